#include "features/decomposition/local_maximum.h"

#include <catch2/catch.hpp>

#include "tests/support/analytic_fields.h"
#include "tests/support/brute_force.h"
#include "tests/support/whole_space.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("from anywhere in a cube the climb ends in the middle") {
  const BoxField cube({1.0, 1.0, 1.0});
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    RemainingSpace space = whole_space(cube);
    const LocalMaximum maximum = find_local_maximum(space, random_point(random, 0.95), 0.1, 1e-13);
    CHECK(maximum.ball.radius == Approx(1.0).epsilon(1e-10));
    CHECK(maximum.ball.center.norm() < 1e-9);
    CHECK(maximum.basin_radius <= 2.0 / std::sqrt(3.0) * (1 + 1e-6));
  }
}

TEST_CASE("the second ball of a cube touches three faces and the first ball") {
  const double radius = (std::sqrt(3.0) - 1) / (std::sqrt(3.0) + 1);
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const BoxField cube({1.0, 1.0, 1.0});
    RemainingSpace remaining = whole_space(cube);
    remaining.place({{0, 0, 0}, 1.0}, 1.0);
    const Eigen::Vector3d start = Eigen::Vector3d::Constant(0.8) + random_point(random, 0.1);
    const LocalMaximum maximum = find_local_maximum(remaining, start, 0.05, 1e-13);
    CHECK(maximum.ball.radius == Approx(radius).epsilon(1e-10));
  }
}

TEST_CASE("a ball that can slide has no basin") {
  const BoxField rod({2.0, 0.5, 0.5});
  RemainingSpace space = whole_space(rod);
  const LocalMaximum maximum = find_local_maximum(space, {0.1, 0.1, 0.1}, 0.1, 1e-13);
  CHECK(maximum.ball.radius == Approx(0.5).epsilon(1e-10));
  CHECK(maximum.basin_radius < 1e-3);
}

TEST_CASE("no centre in the basin admits a larger ball") {
  const BoxField box({1.0, 0.8, 0.6});
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    RemainingSpace space = whole_space(box);
    const std::vector<Ball> balls{{{0.2, 0.1, 0.0}, 0.6}};
    space.place(balls[0], 0.6);
    const Eigen::Vector3d start(0.9, 0.7, 0.5);
    const LocalMaximum maximum = find_local_maximum(space, start, 0.05, 1e-13);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d point = maximum.ball.center + random_point(random, 1.0).normalized() *
                                                              maximum.basin_radius * (i / 200.0);
      const double value =
          std::min(box.measure({.point = point}).distance, ball_distance(balls, point));
      CHECK(value <= maximum.ball.radius * (1 + 2 * contact_accuracy));
    }
  }
}

TEST_CASE("hold strength is the radius of the ball inside the hull of the directions") {
  using Vectors = std::vector<Eigen::Vector3d>;
  const double s = 1 / std::sqrt(3.0);
  const Vectors tetrahedron{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
  const Vectors octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Vectors pair{{0, 0, 1}, {0, 0, -1}};
  const Vectors ring{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  const Vectors one_side{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {s, s, s}};
  CHECK(hold_strength(tetrahedron) == Approx(1.0 / 3.0));
  CHECK(hold_strength(octahedron) == Approx(s));
  CHECK(hold_strength(pair) == 0.0);
  CHECK(hold_strength(ring) == Approx(0.0).margin(1e-12));
  CHECK(hold_strength(one_side) == 0.0);
  CHECK(hold_strength({}) == 0.0);
}
