#include "features/distance/enclosing_ball.h"

#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

// Moves towards the farthest point with shrinking steps (Badoiu and Clarkson 2003): an upper bound
// that converges slowly.
double radius_by_iteration(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d center = points.front();
  double radius = 0.0;
  for (int step = 1; step <= 200000; ++step) {
    const Eigen::Vector3d* farthest = &points.front();
    for (const Eigen::Vector3d& point : points) {
      if ((point - center).squaredNorm() > (*farthest - center).squaredNorm()) farthest = &point;
    }
    radius = (*farthest - center).norm();
    center += (*farthest - center) / (step + 1.0);
  }
  return radius;
}

}  // namespace

TEST_CASE("enclosing balls of known shapes") {
  SECTION("one point") {
    const std::vector<Eigen::Vector3d> points{{1, 2, 3}};
    CHECK(enclosing_ball(points).radius == 0.0);
  }
  SECTION("two points") {
    const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {2, 0, 0}};
    CHECK(enclosing_ball(points).radius == Approx(1.0));
    CHECK(enclosing_ball(points).center.isApprox(Eigen::Vector3d(1, 0, 0)));
  }
  SECTION("an obtuse triangle rests on its longest side") {
    const std::vector<Eigen::Vector3d> points{{-2, 0, 0}, {2, 0, 0}, {0, 0.5, 0}};
    CHECK(enclosing_ball(points).radius == Approx(2.0));
  }
  SECTION("collinear and repeated points") {
    const std::vector<Eigen::Vector3d> points{
        {0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {1, 1, 1}, {0, 0, 0}};
    CHECK(enclosing_ball(points).radius == Approx(1.5 * std::sqrt(3.0)));
  }
  SECTION("a cube") {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    CHECK(enclosing_ball(points).radius == Approx(0.5 * std::sqrt(3.0)).epsilon(1e-12));
  }
  SECTION("points on a sphere") {
    std::mt19937 random(1);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 2000; ++i)
      points.push_back(random_rotation(random) * Eigen::Vector3d(7, 0, 0));
    CHECK(enclosing_ball(points).radius == Approx(7.0).epsilon(1e-3));
    CHECK(enclosing_ball(points).radius <= 7.0 * (1 + 1e-12));
  }
}

TEST_CASE("an enclosing ball encloses all points and is the smallest") {
  std::mt19937 random(2);
  for (int round = 0; round < 10; ++round) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 5 + 10 * round; ++i) points.push_back(random_point(random, 1.0));
    const Ball ball = enclosing_ball(points);
    for (const Eigen::Vector3d& point : points) {
      CHECK((point - ball.center).norm() <= ball.radius * (1 + 1e-12));
    }
    CHECK(ball.radius <= radius_by_iteration(points) * (1 + 1e-12));
    CHECK(ball.radius == Approx(radius_by_iteration(points)).epsilon(1e-4));
  }
}

// At the smallest ball the points on the surface hold its centre in their hull: moving the centre
// any way makes the ball larger.
TEST_CASE("no enclosing ball of many random sets can shrink by moving") {
  std::mt19937 random(4);
  for (int round = 0; round < 3000; ++round) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 4 + round % 50; ++i) points.push_back(random_point(random, 1.0));
    const Ball ball = enclosing_ball(points);
    std::vector<Eigen::Vector3d> held;
    for (const Eigen::Vector3d& point : points) {
      const double distance = (point - ball.center).norm();
      REQUIRE(distance <= ball.radius * (1 + 1e-12));
      if (distance >= ball.radius * (1 - 1e-9)) held.push_back(point - ball.center);
    }
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector3d direction = random_point(random, 1.0).normalized();
      double lowest = 1.0;
      for (const Eigen::Vector3d& point : held) lowest = std::min(lowest, direction.dot(point));
      REQUIRE(lowest <= 1e-7);
    }
  }
}

TEST_CASE("the enclosing ball moves with its points") {
  std::mt19937 random(3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 300; ++i) points.push_back(random_point(random, 1.0));
  const Ball ball = enclosing_ball(points);
  const Eigen::Quaterniond rotation = random_rotation(random);
  const Eigen::Vector3d offset(10, -20, 30);
  for (Eigen::Vector3d& point : points) point = 5.0 * (rotation * point) + offset;
  const Ball moved = enclosing_ball(points);
  CHECK(moved.radius == Approx(5.0 * ball.radius).epsilon(1e-12));
  CHECK((moved.center - (5.0 * (rotation * ball.center) + offset)).norm() < 1e-10);
}
