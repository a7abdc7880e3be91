#include "features/decomposition/ball_set.h"

#include <algorithm>
#include <array>

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

const Ball domain{{0, 0, 0}, std::sqrt(3.0)};

}  // namespace

TEST_CASE("the nearest balls agree with sorting all of them") {
  std::mt19937 random(1);
  const double reach = 0.25;
  BallSet set(domain);
  std::vector<Ball> balls;
  for (int i = 0; i < 300; ++i) {
    balls.push_back({random_point(random, 1.0), 0.005 * (i % 50)});
    set.add(balls.back(), reach);
  }
  for (int round = 0; round < 200; ++round) {
    const Eigen::Vector3d point = random_point(random, 1.0);
    std::vector<double> gaps;
    for (const Ball& ball : balls) gaps.push_back((point - ball.center).norm() - ball.radius);
    std::sort(gaps.begin(), gaps.end());
    const double limit = std::min(gaps[static_cast<std::size_t>(round) % 12], reach);
    const auto expected =
        static_cast<std::size_t>(std::upper_bound(gaps.begin(), gaps.end(), limit) - gaps.begin());
    std::array<std::uint32_t, 8> nearest;
    const std::size_t found = set.find_nearest(point, limit, nearest);
    REQUIRE(found == std::min<std::size_t>(8, expected));
    for (std::size_t i = 0; i < found; ++i) {
      REQUIRE(set.witness(nearest[i]).value(point) == Approx(gaps[i]).margin(1e-12));
    }
  }
}

TEST_CASE("an update with the new balls finds what a search of all finds") {
  std::mt19937 random(2);
  BallSet set(domain);
  for (int round = 0; round < 300; ++round) {
    const Eigen::Vector3d point = random_point(random, 1.0);
    const std::size_t before = set.size();
    std::array<std::uint32_t, 4> updated;
    const std::size_t known = set.find_nearest(point, 0.3, updated);
    set.add({random_point(random, 1.0), 0.1}, 0.3);
    set.add({random_point(random, 1.0), 0.05}, 0.3);
    const std::size_t count = set.update_nearest(point, 0.3, before, updated, known);
    std::array<std::uint32_t, 4> searched;
    REQUIRE(set.find_nearest(point, 0.3, searched) == count);
    REQUIRE(std::equal(updated.begin(), updated.begin() + count, searched.begin()));
    const bool has_new = std::any_of(updated.begin(), updated.begin() + count,
                                     [&](std::uint32_t ball) { return ball >= before; });
    if (has_new) REQUIRE(set.has_near(point, 0.3, before));
  }
}

TEST_CASE("a ball is clear of those that it does not overlap") {
  BallSet set(domain);
  set.add({{0, 0, 0}, 0.5}, 0.1);
  set.add({{1, 0, 0}, 0.25}, 0.1);
  CHECK(set.is_clear({{0, 1, 0}, 0.5}, 0));
  CHECK_FALSE(set.is_clear({{0, 1, 0}, 0.51}, 0));
  CHECK(set.is_clear({{0, 1, 0}, 0.51}, 1));
  CHECK_FALSE(set.is_clear({{1, 0, 0.5}, 0.3}, 1));
}

TEST_CASE("without balls nothing is near") {
  std::array<std::uint32_t, 2> nearest;
  CHECK(BallSet(domain).find_nearest({0, 0, 0}, 1e9, nearest) == 0);
  CHECK_FALSE(BallSet(domain).has_near({0, 0, 0}, 1e9, 0));
}
