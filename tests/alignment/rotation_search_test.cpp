#include "features/alignment/rotation_search.h"

#include <algorithm>
#include <numbers>

#include <catch2/catch.hpp>

#include "features/alignment/trial_rotations.h"
#include "tests/support/ball_clouds.h"
#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

double angle_between(const Eigen::Matrix3d& left, const Eigen::Matrix3d& right) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(left.transpose() * right)).angle();
}

}  // namespace

TEST_CASE("trial rotations begin with those of the axes and leave none far from all") {
  const std::vector<Eigen::Matrix3d> rotations = trial_rotations(600);
  REQUIRE(rotations.size() == 624);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    REQUIRE((rotations[i] * rotations[i].transpose()).isIdentity(1e-12));
    REQUIRE(rotations[i].determinant() == Approx(1.0));
  }
  for (std::size_t i = 0; i < 24; ++i) {
    CHECK(rotations[i].cwiseAbs().sum() == 3.0);
    for (std::size_t j = 0; j < i; ++j) CHECK(angle_between(rotations[i], rotations[j]) > 1.5);
  }
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Matrix3d rotation = random_rotation(random).toRotationMatrix();
    double nearest = std::numbers::pi;
    for (const Eigen::Matrix3d& trial : rotations) {
      nearest = std::min(nearest, angle_between(rotation, trial));
    }
    CHECK(nearest < 26.0 / 180.0 * std::numbers::pi);
  }
}

TEST_CASE("the motion of moved balls is among the likely ones") {
  const bool is_mirrored = GENERATE(false, true);
  // No two axes of this heap of balls are alike.
  const std::vector<Ball> balls = {{{0, 0, 0}, 2.0},   {{4, 0, 0}, 1.5}, {{0, 3, 0}, 1.0},
                                   {{0, 0, 2.6}, 0.6}, {{6, 1, 0}, 0.5}, {{-2.5, 0, 0.4}, 0.4}};
  Eigen::Matrix3d turn = some_rotation();
  if (is_mirrored) turn *= Eigen::Vector3d(1, -1, 1).asDiagonal();
  const Eigen::Vector3d shift(30, -20, 10);
  const std::vector<Ball> moved = moved_balls(balls, turn, 25.4, shift);
  const Similarity best = RotationSearch(balls, moved).likely().front();
  CHECK((best.rotation - turn).norm() < 1e-6);
  CHECK(best.scale == Approx(25.4));
  CHECK((best.translation - shift).norm() < 1e-4);
  CHECK(best.mirrors() == is_mirrored);
}

TEST_CASE("polishing finds what fits in a narrow range of angles, and nothing twice") {
  // A wheel with 16 spokes of two balls each, one of which is short.
  std::vector<Ball> balls = {{{0, 0, 0}, 3.0}};
  for (int spoke = 0; spoke < 16; ++spoke) {
    const double angle = std::numbers::pi / 8 * spoke;
    const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0);
    balls.push_back({3.5 * direction, 0.5});
    if (spoke > 0) balls.push_back({4.5 * direction, 0.5});
  }
  balls.push_back({{0, 0, 4.0}, 1.0});  // the axle
  const Eigen::Matrix3d turn = some_rotation();
  const std::vector<Ball> moved = moved_balls(balls, turn, 1.0, {1, 2, 3});
  const std::vector<Similarity> motions = RotationSearch(balls, moved).polished();
  const auto [nearest, farthest] = std::ranges::minmax(
      motions, {}, [&](const Similarity& motion) { return (motion.rotation - turn).norm(); });
  CHECK((nearest.rotation - turn).norm() < 0.05);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      CHECK((motions[i].rotation - motions[j].rotation).norm() > 0.05);
    }
  }
}
