#include "features/decomposition/cube_bounds.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

constexpr double weight = 1e-4;

const Preference& preference() {
  static const Preference outward = Preference::outward({{0.1, 0.2, 0.3}, 2.0}, weight);
  return outward;
}

/// Points, balls and triangles, with what the witnesses refer to.
struct Scene {
  std::vector<Witness> witnesses;
  std::vector<std::unique_ptr<FlatPiece>> pieces;

  Scene(std::mt19937& random, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Eigen::Vector3d center = random_point(random, 1.0);
      if (i % 3 == 0) witnesses.push_back({center});
      if (i % 3 == 1) witnesses.push_back({center, 0.3});
      if (i % 3 == 2) {
        const std::array<Eigen::Vector3d, 3> corners{center, center + random_point(random, 1.0),
                                                     center + random_point(random, 1.0)};
        pieces.push_back(std::make_unique<FlatPiece>(corners));
        witnesses.push_back({center, 0.0, pieces.back().get()});
      }
    }
  }

  WitnessLanes lanes() const {
    WitnessLanes lanes;
    for (const Witness& witness : witnesses) lanes.add(witness);
    return lanes;
  }
};

// Checks bounds at random points of a cube.
void check_bounds(const CubeBounds& bounds, const Scene& scene, const Eigen::Vector3d& center,
                  double half_size, std::mt19937& random) {
  REQUIRE(bounds.count == scene.witnesses.size());
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector3d offset = random_point(random, half_size);
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < bounds.count; ++k) {
      const Eigen::Vector3d point = center + offset;
      const double rank = scene.witnesses[k].value(point) * preference().factor(point);
      lowest = std::min(lowest, rank);
      if (rank <= 0) continue;
      const Eigen::Vector3d slope(bounds.slope[0][k], bounds.slope[1][k], bounds.slope[2][k]);
      REQUIRE(rank <= bounds.offset[k] + slope.dot(offset) + 1e-12);
    }
    if (lowest > 0) REQUIRE(lowest <= bounds.smallest + 1e-12);
  }
}

}  // namespace

TEST_CASE("what witnesses allow is nowhere above its bounds") {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const Scene scene(random, 1 + round % WitnessLanes::capacity);
    const Eigen::Vector3d center = random_point(random, 1.0);
    for (const double half_size : {1.0, 0.1, 0.001}) {
      check_bounds(bound_over_cube(scene.lanes(), preference(), center, half_size), scene, center,
                   half_size, random);
      const OctantBounds octants(scene.lanes(), center, half_size);
      for (int octant = 0; octant < 8; ++octant) {
        const Eigen::Vector3d sides(octant & 1, octant >> 1 & 1, octant >> 2);
        const Eigen::Vector3d middle =
            center + half_size * (sides - Eigen::Vector3d::Constant(0.5));
        check_bounds(octants.of_octant(octant, preference()), scene, middle, 0.5 * half_size,
                     random);
      }
    }
  }
}

TEST_CASE("bounds are second order in small cubes, and exact above a flat piece") {
  const std::array<Eigen::Vector3d, 3> corners{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}};
  const FlatPiece piece(corners);
  WitnessLanes lanes;
  lanes.add({{0, 0, 0}, 0.0, &piece});
  lanes.add({{0, 0, 0}});
  const Eigen::Vector3d center(0, 0, 1);
  for (const double half_size : {0.1, 0.01, 0.001}) {
    const CubeBounds bounds = bound_over_cube(lanes, preference(), center, half_size);
    const double rank = preference().factor(center);
    const double rounding = 10.0 * weight * half_size * half_size;
    CHECK(bounds.offset[0] >= rank);
    CHECK(bounds.offset[0] <= rank + rounding);
    CHECK(bounds.offset[1] >= rank);
    CHECK(bounds.offset[1] <= rank + 1.5 * half_size * half_size + rounding);
  }
}
