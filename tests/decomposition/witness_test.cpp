#include "features/decomposition/witness.h"

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

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
