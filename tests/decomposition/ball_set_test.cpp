#include "features/decomposition/ball_set.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("the nearest balls agree with sorting all of them") {
  std::mt19937 random(1);
  BallSet set;
  std::vector<Ball> balls;
  for (int i = 0; i < 300; ++i) {
    balls.push_back({random_point(random, 1.0), 0.001 * (i % 50)});
    set.add(balls.back());
  }
  for (int round = 0; round < 100; ++round) {
    const Eigen::Vector3d point = random_point(random, 1.0);
    std::vector<double> gaps;
    for (const Ball& ball : balls) gaps.push_back((point - ball.center).norm() - ball.radius);
    std::sort(gaps.begin(), gaps.end());
    const double limit = gaps[static_cast<std::size_t>(round) % 12];
    std::array<std::uint32_t, 8> nearest;
    const std::size_t found = set.find_nearest(point, limit, nearest);
    REQUIRE(found == std::min<std::size_t>(8, round % 12 + 1));
    for (std::size_t i = 0; i < found; ++i) REQUIRE(set.witness(nearest[i]).value(point) == Approx(gaps[i]));
    REQUIRE(set.gap(point, 100.0) == Approx(ball_distance(balls, point)));
  }
}

TEST_CASE("without balls nothing is near") {
  std::array<std::uint32_t, 2> nearest;
  CHECK(BallSet().find_nearest({0, 0, 0}, 1e9, nearest) == 0);
  CHECK(BallSet().gap({0, 0, 0}, 3.0) == 3.0);
}
