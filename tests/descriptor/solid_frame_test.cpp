#include "features/descriptor/solid_frame.h"

#include <catch2/catch.hpp>

#include "tests/support/ball_clouds.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("one ball lies at the origin with the radius that makes its mean square distance 1") {
  const std::vector<Ball> balls = to_solid_frame(std::vector<Ball>{{{5, -3, 2}, 7.0}});
  CHECK(balls[0].center.norm() == 0.0);
  CHECK(balls[0].radius == Approx(std::sqrt(5.0 / 3)));
}

TEST_CASE("two equal balls lie on either side of the origin") {
  const std::vector<Ball> balls =
      to_solid_frame(std::vector<Ball>{{{1, 0, 0}, 1.0}, {{3, 0, 0}, 1.0}});
  const double scale = std::sqrt(1.6);  // 1 of the centres, 3/5 of the balls
  CHECK(balls[0].center.x() == Approx(-1 / scale));
  CHECK(balls[1].center.x() == Approx(1 / scale));
  CHECK(balls[0].radius == Approx(1 / scale));
}

TEST_CASE("a moved and scaled shape has the same frame, however small or far") {
  const std::vector<Ball> balls = random_balls(50, 3);
  const std::vector<Ball> expected = to_solid_frame(balls);
  for (const double scale : {1e-30, 1.0, 1e60}) {
    const std::vector<Ball> found = to_solid_frame(moved_balls(
        balls, Eigen::Matrix3d::Identity(), scale, scale * Eigen::Vector3d(100, 0, -3)));
    for (std::size_t i = 0; i < balls.size(); ++i) {
      CHECK((found[i].center - expected[i].center).norm() < 1e-10);
      CHECK(found[i].radius == Approx(expected[i].radius));
    }
  }
}
