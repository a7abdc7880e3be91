#include "features/solidify/orient_shells.h"

#include <chrono>
#include <utility>

#include <catch2/catch.hpp>

#include "features/solidify/face_neighbours.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

void add_tetrahedron(TriangleMesh& mesh, const Eigen::Vector3d& origin, bool is_inverted) {
  const auto start = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(origin);
  for (int axis = 0; axis < 3; ++axis) {
    mesh.vertices.push_back(origin + Eigen::Vector3d::Unit(axis));
  }
  for (auto [a, b, c] : {Triangle{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}) {
    if (is_inverted) std::swap(b, c);
    mesh.triangles.push_back({a + start, b + start, c + start});
  }
}

}  // namespace

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

TEST_CASE("of a great many shells each inverted one is turned, soon") {
  TriangleMesh mesh;
  constexpr std::uint32_t across = 300;
  for (std::uint32_t i = 0; i < across * across; ++i) {
    add_tetrahedron(mesh, {2.0 * (i % across), 2.0 * (i / across), 0.0}, i % 2 == 1);
  }
  const auto start = std::chrono::steady_clock::now();
  CHECK(orient_shells(mesh) == across * across / 2 * 4);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
  CHECK(six_volumes(mesh) == Approx(across * across));
}
