#include "features/decomposition/flat_pieces.h"

#include <catch2/catch.hpp>

#include "features/distance/mesh_distance_field.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

/// A cube whose sides are cut into an irregular pattern of triangles, so that no convex piece is
/// large, with a box cut out of one corner, so that three sides are not convex.
TriangleMesh make_notched_cube() {
  const std::array<double, 5> at{0.0, 0.3, 0.5, 0.55, 1.0};
  const auto is_filled = [](int i, int j, int k) {
    if (i < 0 || j < 0 || k < 0 || i > 3 || j > 3 || k > 3) return false;
    return i < 2 || j < 2 || k < 2;
  };
  TriangleMesh mesh;
  for (double z : at) {
    for (double y : at) {
      for (double x : at) mesh.vertices.emplace_back(x, y, z);
    }
  }
  const auto corner = [](int i, int j, int k) {
    return static_cast<std::uint32_t>(i + 5 * (j + 5 * k));
  };
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) {
        for (int side = 0; side < 6 && is_filled(i, j, k); ++side) {
          std::array<int, 3> cell{i, j, k};
          const int axis = side / 2;
          cell[axis] += side % 2 == 0 ? -1 : 1;
          if (is_filled(cell[0], cell[1], cell[2])) continue;
          std::array<std::uint32_t, 4> quad;
          for (int c = 0; c < 4; ++c) {
            std::array<int, 3> p{i, j, k};
            p[axis] += side % 2;
            p[(axis + 1) % 3] += c == 1 || c == 2 ? 1 : 0;
            p[(axis + 2) % 3] += c >= 2 ? 1 : 0;
            quad[c] = corner(p[0], p[1], p[2]);
          }
          if (side % 2 == 0) std::swap(quad[1], quad[3]);
          mesh.triangles.push_back({quad[0], quad[1], quad[2]});
          mesh.triangles.push_back({quad[0], quad[2], quad[3]});
        }
      }
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("a piece belongs to the boundary and contains the sample") {
  const TriangleMesh mesh = make_notched_cube();
  REQUIRE(six_volumes(mesh) == Approx(6.0 * (1.0 - 0.5 * 0.5 * 0.5)));
  const MeshDistanceField field(mesh, true);
  FlatPieces pieces;
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    Eigen::Vector3d point = Eigen::Vector3d::Constant(0.5) + random_point(random, 0.6);
    if (i % 3 == 0) point.x() = 0.3;  // above the edges of the pattern
    const DistanceSample sample = field.measure({.point = point});
    const FlatPiece* piece = pieces.around(sample);
    REQUIRE(piece != nullptr);
    REQUIRE(piece->linearise(point).offset == Approx(std::abs(sample.distance)).margin(1e-12));
    const Eigen::Vector3d other = Eigen::Vector3d::Constant(0.5) + random_point(random, 0.6);
    REQUIRE(piece->linearise(other).offset >= mesh_distance(mesh, other) - 1e-12);
  }
}

TEST_CASE("in the middle of a side the piece reaches across the pattern") {
  const MeshDistanceField field(make_notched_cube(), true);
  FlatPieces pieces;
  const FlatPiece* piece = pieces.around(field.measure({.point = {0.5, 0.5, 0.1}}));
  // Above a point 0.4 away in the plane z = 0 the distance is still that from the plane.
  CHECK(piece->linearise({0.9, 0.5, 0.1}).offset == Approx(0.1));
  CHECK(piece->linearise({0.5, 0.1, 0.1}).offset == Approx(0.1));
}
