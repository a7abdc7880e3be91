#include "features/distance/flat_regions.h"

#include <catch2/catch.hpp>

#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

double radius_at(const TriangleMesh& mesh, const Eigen::Vector3d& point, std::uint32_t triangle) {
  return FlatRegions(mesh).around(point, triangle).radius;
}

/// The plate [0, 3]^2 with the square hole [1, 2]^2, cut into triangles.
TriangleMesh make_frame() {
  TriangleMesh mesh;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) mesh.vertices.emplace_back(i, j, 0.0);
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      const std::uint32_t a = 4 * i + j;
      if (i == 1 && j == 1) continue;
      mesh.triangles.push_back({a, a + 4, a + 5});
      mesh.triangles.push_back({a, a + 5, a + 1});
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("the sides of a cube are flat up to their edges, across the diagonals") {
  const TriangleMesh cube = make_cube();
  // The first two triangles are the bottom, z = 0.
  for (const std::uint32_t triangle : {0U, 1U}) {
    CHECK(radius_at(cube, {0.5, 0.5, 0.0}, triangle) == Approx(0.5));
    CHECK(radius_at(cube, {0.2, 0.6, 0.0}, triangle) == Approx(0.2));
  }
}

TEST_CASE("a flat region may have any outline") {
  const TriangleMesh frame = make_frame();
  CHECK(radius_at(frame, {0.5, 0.5, 0.0}, 0) == Approx(0.5));
  CHECK(radius_at(frame, {0.9, 0.9, 0.0}, 0) == Approx(0.1 * std::sqrt(2.0)));  // the hole's corner
  CHECK(radius_at(frame, {0.6, 1.5, 0.0}, 2) == Approx(0.4));                   // the hole's side
}

TEST_CASE("triangles of one region have its number, others have not") {
  const FlatRegions cube(make_cube());
  CHECK(cube.around({0.5, 0.5, 0.0}, 0).number == cube.around({0.5, 0.5, 0.0}, 1).number);
  CHECK(cube.around({0.5, 0.5, 0.0}, 0).number != cube.around({0.5, 0.5, 1.0}, 2).number);
}

TEST_CASE("a triangle that lies in no plane with its neighbours is no region") {
  TriangleMesh mesh;
  SECTION("a bent surface") {
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1e-6}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 3}, {1, 2, 3}};
  }
  SECTION("triangles that face each other") {
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {2, 1, 0}};
  }
  CHECK(radius_at(mesh, {0.25, 0.25, 0.0}, 0) == 0.0);
}
