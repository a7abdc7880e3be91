#include "bench/ball_quality.h"

#include <catch2/catch.hpp>

#include "tests/support/analytic_fields.h"

using namespace mdbd;

namespace {

const test::BoxField box({3.0, 1.0, 1.0});  // R is the root of 11

bench::BallQuality quality_of(const std::vector<Ball>& balls, const std::vector<Ball>& reference) {
  return bench::measure_quality(box, balls, reference);
}

}  // namespace

TEST_CASE("perfect balls have no faults") {
  const std::vector<Ball> balls = {{{-2, 0, 0}, 1}, {{0, 0, 0}, 1}, {{2, 0, 0}, 1}};
  const bench::BallQuality quality = quality_of(balls, balls);
  CHECK(quality.balls == 3);
  CHECK(quality.contacts == 2);
  CHECK(quality.escape == 0.0);
  CHECK(quality.overlap == 0.0);
  CHECK(quality.order_violation == 0.0);
  CHECK(quality.radius_error == 0.0);
}

TEST_CASE("faults are measured") {
  const std::vector<Ball> balls = {{{-2, 0, 0}, 0.5}, {{0, 0, 0}, 1.1}, {{1, 0, 0}, 0.4}};
  const std::vector<Ball> reference = {{{-2, 0, 0}, 1}, {{0, 0, 0}, 1}, {{2, 0, 0}, 1}, {}};
  const bench::BallQuality quality = quality_of(balls, reference);
  CHECK(quality.contacts == 1);
  CHECK(quality.escape == Approx(0.1 / std::sqrt(11.0)));
  CHECK(quality.overlap == Approx(0.5 / std::sqrt(11.0)));
  CHECK(quality.order_violation == Approx(1.2));
  CHECK(quality.radius_error == Approx((0.1 + 0.5 + 0.6 + 1.0) / 4));
}
