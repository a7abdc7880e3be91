#include "features/decomposition/witness.h"

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("a bound over a cube is never below the value and close to it in small cubes") {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const std::array<Eigen::Vector3d, 3> piece{random_point(random, 1.0), random_point(random, 1.0),
                                random_point(random, 1.0)};
    Witness witness{piece[0], round % 3 == 0 ? 0.0 : 0.3};
    if (round % 3 == 2) witness = {piece[0], 0.0, piece};
    const Eigen::Vector3d center = random_point(random, 1.0);
    for (const double half_size : {1.0, 0.1, 0.01, 0.001}) {
      const CubeBound bound = witness.bound_over_cube(center, half_size);
      const double distance = witness.value(center) + witness.radius;
      for (int i = 0; i < 50; ++i) {
        const Eigen::Vector3d offset = random_point(random, half_size);
        const double value = witness.value(center + offset);
        const double estimate = bound.model.offset + bound.model.slope.dot(offset);
        REQUIRE(value <= estimate + 1e-12);
        REQUIRE(value <= bound.largest + 1e-12);
        if (half_size < 0.1 * distance) {
          REQUIRE(estimate - value <= 2.0 * half_size * half_size / distance + 1e-12);
        }
      }
    }
  }
}

TEST_CASE("above a flat piece a bound is exact") {
  const std::array<Eigen::Vector3d, 3> piece{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}};
  const Witness witness{{0, 0, 0}, 0.0, piece};
  const CubeBound bound = witness.bound_over_cube({0.1, 0.2, 1.0}, 0.5);
  CHECK(bound.largest == Approx(1.5));
  CHECK(bound.model.offset == Approx(1.0));
  CHECK(bound.model.slope.isApprox(Eigen::Vector3d::UnitZ()));
  // A cube much larger than the piece gains nothing from it, but stays bounded.
  CHECK(witness.bound_over_cube({0, 0, 1.0}, 100.0).largest >= 101.0);
}

TEST_CASE("a linear model touches the value from below") {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    const Witness witness{random_point(random, 1.0), 0.2};
    const Eigen::Vector3d center = random_point(random, 1.0);
    const AffineFunction model = witness.linearise(center);
    CHECK(model.offset == Approx(witness.value(center)));
    const Eigen::Vector3d offset = random_point(random, 0.5);
    CHECK(model.offset + model.slope.dot(offset) <= witness.value(center + offset) + 1e-12);
  }
}

TEST_CASE("a witness at the point itself has no direction") {
  const Witness witness{{1, 2, 3}, 0.5};
  CHECK(witness.linearise({1, 2, 3}).offset == -0.5);
  CHECK(witness.linearise({1, 2, 3}).slope.isZero());
}
