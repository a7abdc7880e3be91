#include "features/descriptor/chirality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "features/decomposition/decompose.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/ball_clouds.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

double length(std::span<const float> values) {
  double sum = 0.0;
  for (const float value : values) sum += double{value} * value;
  return std::sqrt(sum);
}

std::vector<Ball> mirrored(const std::vector<Ball>& balls) {
  const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  return moved_balls(balls, mirror, 1.0, {0.5, 0, 0});
}

/// Equal balls along a helix of some turns about z, which a half turn about x leaves as it is.
std::vector<Ball> helix(double turns) {
  std::vector<Ball> balls;
  for (int i = -20; i <= 20; ++i) {
    const double angle = turns * 2 * std::numbers::pi * i / 40;
    balls.push_back({{std::cos(angle), std::sin(angle), 0.1 * i}, 0.05});
  }
  return balls;
}

/// A cloud and its reflection at the plane x = 0.
std::vector<Ball> symmetric_cloud() {
  std::vector<Ball> balls = random_balls(40, 5);
  for (Ball& ball : balls) ball.center.x() += 20;
  for (const Ball& ball : std::vector<Ball>(balls)) {
    balls.push_back({{-ball.center.x(), ball.center.y(), ball.center.z()}, ball.radius});
  }
  return balls;
}

}  // namespace

TEST_CASE("a reflection changes the sign of all numbers of chirality") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const std::vector<Ball> balls = random_balls(50, seed);
    const std::vector<float> left = compute_chirality(balls);
    const std::vector<float> right = compute_chirality(mirrored(balls));
    REQUIRE(left.size() == chirality_size);
    CHECK(length(left) > least_chirality);
    for (std::size_t i = 0; i < chirality_size; ++i) {
      CHECK(left[i] != 0.0F);
      CHECK(right[i] == Approx(-left[i]).margin(1e-6));
    }
    CHECK(compare_hands(left, right) == Hand::mirrored);
  }
}

TEST_CASE("rotation, translation, scale and order leave the chirality as it is") {
  const std::vector<Ball> balls = random_balls(50, 4);
  const std::vector<float> expected = compute_chirality(balls);
  std::vector<Ball> moved = moved_balls(balls, some_rotation(), 25.4, {100, -50, 7});
  std::ranges::reverse(moved);
  const std::vector<float> found = compute_chirality(moved);
  for (std::size_t i = 0; i < chirality_size; ++i) {
    CHECK(found[i] == Approx(expected[i]).margin(1e-6));
  }
  CHECK(compare_hands(expected, found) == Hand::same);
}

TEST_CASE("a shape with a plane of symmetry has no hand, however it lies") {
  const std::vector<float> cloud =
      compute_chirality(moved_balls(symmetric_cloud(), some_rotation(), 2.0, {1, 2, 3}));
  CHECK(length(cloud) < 1e-5);
  const BallDecomposition box = decompose(BoxField({0.5, 0.3, 0.2}), {.balls = 200});
  const std::vector<float> of_box = compute_chirality(box.balls);
  CHECK(length(of_box) < least_chirality);
  CHECK(compare_hands(of_box, of_box) == Hand::none);
}

TEST_CASE("left and right screws are told apart, although no vector is left of them") {
  const std::vector<float> right = compute_chirality(helix(1.5));
  const std::vector<float> left = compute_chirality(helix(-1.5));
  CHECK(length(right) > least_chirality);
  CHECK(compare_hands(right, left) == Hand::mirrored);
  CHECK(compare_hands(right, compute_chirality(helix(1.4))) == Hand::same);
  CHECK(length(compute_chirality(helix(0.0))) < 1e-6);
}

TEST_CASE("chirality changes little when balls change little") {
  const std::vector<Ball> balls = random_balls(60, 9);
  const std::vector<float> expected = compute_chirality(balls);
  for (const double change : {1e-6, 1e-4, 1e-2}) {
    std::vector<Ball> changed = balls;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      changed[i].center += change * Eigen::Vector3d(std::sin(i), std::cos(3 * i), std::sin(7 * i));
      changed[i].radius *= 1 + change * std::cos(5 * i);
    }
    const std::vector<float> found = compute_chirality(changed);
    for (std::size_t i = 0; i < chirality_size; ++i) {
      CHECK(std::abs(found[i] - expected[i]) < 3 * change + 1e-6);
    }
  }
}

TEST_CASE("one ball and none have no hand") {
  CHECK(length(compute_chirality(std::vector<Ball>{{{1, 2, 3}, 2.0}})) == 0.0);
  CHECK(length(compute_chirality({})) == 0.0);
}

TEST_CASE("hands that differ in more than the sign are unclear") {
  std::vector<float> f(chirality_size, 0.0F);
  std::vector<float> g(chirality_size, 0.0F);
  f[0] = 0.1F;
  g[1] = 0.1F;
  CHECK(compare_hands(f, g) == Hand::unclear);
  CHECK(to_string(Hand::unclear) == "unclear");
}
