#include "features/solidify/orient_shells.h"

#include <catch2/catch.hpp>

#include "features/solidify/face_neighbours.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("turned faces of a closed surface are turned back") {
  for (const std::size_t count : {1, 2, 5, 9, 12}) {
    TriangleMesh cube = make_cube();
    for (std::size_t i = 0; i < count; ++i) turn(cube.triangles[i]);
    orient_shells(cube);
    CHECK(six_volumes(cube) == Approx(6.0));
  }
}

TEST_CASE("what is right is left alone") {
  TriangleMesh mesh;
  add_cube(mesh, {0, 0, 0}, 1.0, false);
  add_cube(mesh, {0.25, 0.25, 0.25}, 0.5, true);  // a cavity
  add_cube(mesh, {0.4, 0.4, 0.4}, 0.2, false);    // a solid in the cavity
  add_cube(mesh, {0.5, 0.5, 0.9}, 1.0, false);    // overlaps the first
  const std::vector<Triangle> before = mesh.triangles;
  CHECK(orient_shells(mesh) == 0);
  CHECK(mesh.triangles == before);
}

TEST_CASE("an inverted shell beside others is turned") {
  TriangleMesh mesh;
  add_cube(mesh, {0, 0, 0}, 1.0, false);
  add_cube(mesh, {3, 0, 0}, 1.0, true);
  CHECK(orient_shells(mesh) == 12);
  CHECK(six_volumes(mesh) == Approx(12.0));
}
