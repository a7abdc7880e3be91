#include "features/decomposition/flat_piece.h"

#include <array>

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

Corners random_triangle(std::mt19937& random, int round) {
  Corners corners{random_point(random, 1.0), random_point(random, 1.0), random_point(random, 1.0)};
  if (round % 3 == 0) corners[2] = corners[1] + random_point(random, 1e-4);  // a needle
  return corners;
}

TriangleMesh as_mesh(const Corners& corners) {
  return {{corners.begin(), corners.end()}, {{0, 1, 2}}};
}

}  // namespace

TEST_CASE("the distance of a triangle agrees with brute force") {
  std::mt19937 random(1);
  for (int round = 0; round < 500; ++round) {
    const Corners corners = random_triangle(random, round);
    const FlatPiece piece(corners);
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3d point = random_point(random, 2.0);
      const AffineFunction model = piece.linearise(point);
      const double expected = mesh_distance(as_mesh(corners), point);
      REQUIRE(model.offset == Approx(expected).margin(1e-12));
      REQUIRE(model.slope.norm() == Approx(1.0));
      // The gradient points away from the closest point.
      const double before = mesh_distance(as_mesh(corners), point - 0.5 * expected * model.slope);
      REQUIRE(before == Approx(0.5 * expected).margin(1e-12));
    }
  }
}

TEST_CASE("grids are measured as their points are") {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    const FlatPiece piece(random_triangle(random, round));
    const Eigen::Vector3d lowest = random_point(random, 1.0);
    const double step = round % 2 == 0 ? 0.3 : 0.01;
    std::array<double, 27> octants;
    piece.measure_octants(lowest, step, octants.data());
    std::array<double, 8> corners;
    piece.measure_corners(lowest, step, corners.data());
    for (int node = 0; node < 27; ++node) {
      const Eigen::Vector3d offset(node % 3, node / 3 % 3, node / 9);
      const double expected = piece.linearise(lowest + step * offset).offset;
      REQUIRE(octants[node] == Approx(expected).margin(1e-12));
    }
    for (int node = 0; node < 8; ++node) {
      const Eigen::Vector3d offset(node & 1, node >> 1 & 1, node >> 2);
      const double expected = piece.linearise(lowest + step * offset).offset;
      REQUIRE(corners[node] == Approx(expected).margin(1e-12));
    }
  }
}

TEST_CASE("a polygon counts as a whole") {
  const std::array<Eigen::Vector3d, 5> corners{
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}}};  // with a corner in a side
  const FlatPiece piece(corners);
  CHECK(piece.linearise({1.9, 0.1, 0.5}).offset == Approx(0.5));
  CHECK(piece.linearise({1.9, 0.1, -0.5}).slope.isApprox(-Eigen::Vector3d::UnitZ()));
  CHECK(piece.linearise({3, 2, 0}).offset == Approx(std::sqrt(2.0)));
  CHECK(piece.linearise({1, 0.5, 0}).offset == 0.0);
}
