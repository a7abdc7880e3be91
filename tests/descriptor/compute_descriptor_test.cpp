#include "features/descriptor/compute_descriptor.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "features/decomposition/decompose.h"
#include "tests/support/analytic_fields.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("a descriptor holds scaled radii, then walk sums") {
  const Recipe recipe;
  const BallDecomposition cube = decompose(BoxField({0.5, 0.5, 0.5}), {.balls = 9});
  const Descriptor descriptor = compute_descriptor(cube, recipe);
  REQUIRE(descriptor.values.size() == 100);
  REQUIRE(descriptor.radii().size() == 50);
  REQUIRE(descriptor.walk().size() == 50);
  CHECK(descriptor.radii()[0] == Approx(1.0 / std::sqrt(3.0)).epsilon(1e-6));
  CHECK(descriptor.radii()[8] == Approx(0.133975 * 2 / std::sqrt(3.0)).epsilon(1e-5));
  for (int i = 9; i < 50; ++i) CHECK(descriptor.radii()[i] == 0.0F);
  // Nine balls are all counted, so that each sum is lambda^t.
  for (int t = 1; t <= 50; ++t) CHECK(descriptor.walk()[t - 1] == Approx(std::pow(0.9, t)));
}

TEST_CASE("a single ball has no walk") {
  const Descriptor descriptor =
      compute_descriptor(decompose(UnitBallField(), {.balls = 5}), Recipe{});
  CHECK_FALSE(descriptor.walk_is_defined);
  CHECK(descriptor.radii()[0] == Approx(1.0));
  for (const float sum : descriptor.walk()) CHECK(sum == 0.0F);
}
