#include "features/alignment/surface_overlay.h"

#include <array>

#include <catch2/catch.hpp>

#include "tests/support/analytic_fields.h"
#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

/// The unit ball, filled by one ball.
const UnitBallField unit_ball;
const std::array<Ball, 1> one_ball = {Ball{Eigen::Vector3d::Zero(), 1.0}};

}  // namespace

TEST_CASE("points of a sphere are as far from a concentric one as the radii differ") {
  const SurfaceOverlay overlay({unit_ball, one_ball}, {unit_ball, one_ball}, 1);
  const std::vector<PointError> errors = overlay.measure({.scale = 0.8});
  REQUIRE(errors.size() == 8);  // two at the ball and two around it, of each shape
  for (const PointError& error : errors) {
    CHECK(error.error == Approx(0.2));
    // Growing makes the first shape fit better.
    CHECK(error.gradient.dot(error.point.normalized()) == Approx(-1.0));
  }
}

TEST_CASE("distances within the resolution of the other shape are no error") {
  const PackedShape vague{.field = unit_ball, .balls = one_ball, .resolution = 0.05};
  const SurfaceOverlay overlay({unit_ball, one_ball}, vague, 1);
  std::vector<double> errors;
  for (const PointError& error : overlay.measure({.scale = 0.8})) errors.push_back(error.error);
  CHECK(errors.front() == Approx(0.15));  // of the first shape from the vague one
  CHECK(errors.back() == Approx(0.2));    // of the vague shape from the first one
}

TEST_CASE("refining ends where the surfaces agree, whatever the size and place of the shapes") {
  const BoxField box({3.0, 2.0, 1.0});
  std::vector<Ball> balls;
  for (const double x : {-2.0, 0.0, 2.0}) {
    for (const double y : {-1.0, 1.0}) balls.push_back({{x, y, 0.0}, 1.0});
  }
  const SurfaceOverlay overlay({box, balls}, {box, balls}, balls.size());
  Eigen::Vector3d axis(0.3, -0.5, 0.8);
  const Similarity start{.rotation = Eigen::AngleAxisd(0.15, axis.normalized()).toRotationMatrix(),
                         .scale = 1.1,
                         .translation = {0.2, -0.1, 0.1}};
  CHECK(largest_error(overlay.measure(start)) > 0.05);
  const Similarity refined = overlay.refine(start);
  CHECK(largest_error(overlay.measure(refined)) < 1e-6);
  CHECK(refined.scale == Approx(1.0).margin(1e-6));
}
