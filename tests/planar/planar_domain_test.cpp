#include "features/planar/planar_domain.h"

#include <limits>

#include <catch2/catch.hpp>

#include "features/core/errors.h"

using namespace mdbd;

namespace {

Outline square(double from, double to) { return {{from, from}, {to, from}, {to, to}, {from, to}}; }

}  // namespace

TEST_CASE("simple outlines stay as they are, to the bit") {
  const Outline outline = {{0.1, 0.2}, {1.0 / 3.0, 0.21}, {0.7, 1.1}};
  const PlanarDomain simple = simplify({outline});
  REQUIRE(simple.size() == 1);
  REQUIRE(simple[0].size() == 3);
  for (const Eigen::Vector2d& point : outline) CHECK(std::ranges::count(simple[0], point) == 1);
}

TEST_CASE("an outline within another is a hole, whichever way it turns") {
  Outline hole = square(1.0, 2.0);
  const double expected = 9.0 - 1.0;
  CHECK(area(simplify({square(0.0, 3.0), hole})) == Approx(expected));
  std::ranges::reverse(hole);
  const PlanarDomain simple = simplify({square(0.0, 3.0), hole});
  CHECK(area(simple) == Approx(expected));
  CHECK(simple.size() == 2);
}

TEST_CASE("where two outlines overlap the domain has a hole") {
  CHECK(area(simplify({square(0.0, 2.0), square(1.0, 3.0)})) == Approx(4.0 + 4.0 - 2.0));
}

TEST_CASE("an outline that crosses itself encloses both of its parts") {
  const PlanarDomain bow_tie = {{{0, 0}, {2, 2}, {2, 0}, {0, 2}}};
  CHECK(area(simplify(bow_tie)) == Approx(2.0));
}

TEST_CASE("huge and tiny domains keep their shape") {
  for (const double scale : {1e-100, 1e-8, 1e12, 1e100}) {
    CHECK(area(simplify({square(0.0, scale)})) / scale / scale == Approx(1.0));
  }
}

TEST_CASE("what has no area is no domain") {
  CHECK_THROWS_AS(simplify({}), InvalidInput);
  CHECK_THROWS_AS(simplify({{{0, 0}, {0, 0}}}), InvalidInput);
  CHECK_THROWS_AS(simplify({{{0, 0}, {1, 1}, {2, 2}}}), InvalidInput);
  CHECK_THROWS_AS(simplify({square(0.0, 1.0), square(0.0, 1.0)}), InvalidInput);
  CHECK_THROWS_AS(simplify({square(0.0, std::numeric_limits<double>::quiet_NaN())}), InvalidInput);
  CHECK_THROWS_AS(simplify({square(0.0, std::numeric_limits<double>::infinity())}), InvalidInput);
}
