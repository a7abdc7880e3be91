#include "perturbation/random_vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

namespace mdbd::test {
namespace {

constexpr int draws = 40'000;

}  // namespace

TEST_CASE("vectors fill the unit ball evenly") {
  Random random(1);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  int inner = 0;
  for (int i = 0; i < draws; ++i) {
    const Eigen::Vector3d vector = random_in_unit_ball(random);
    REQUIRE(vector.norm() <= 1);
    mean += vector / draws;
    moments += vector * vector.transpose() / draws;
    inner += vector.norm() < std::cbrt(0.5) ? 1 : 0;  // half of the volume
  }
  CHECK(mean.norm() < 0.01);
  CHECK((moments - Eigen::Matrix3d::Identity() / 5).norm() < 0.01);  // the moments of the ball
  CHECK(std::abs(inner - draws / 2) < 500);
}

TEST_CASE("directions are even on the sphere") {
  Random random(2);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  std::array<int, 4> slices{};  // of equal height, hence of equal area
  for (int i = 0; i < draws; ++i) {
    const Eigen::Vector3d direction = random_direction(random);
    REQUIRE(direction.norm() == Approx(1.0).epsilon(1e-12));
    mean += direction / draws;
    ++slices[static_cast<std::size_t>(std::min(3.0, 2 * direction.z() + 2))];
  }
  CHECK(mean.norm() < 0.02);
  for (const int count : slices) CHECK(std::abs(count - draws / 4) < 450);
}

TEST_CASE("rotations are even among all rotations") {
  Random random(3);
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
  int half_turns = 0;
  for (int i = 0; i < draws; ++i) {
    const Eigen::Quaterniond rotation = random_rotation(random);
    REQUIRE(rotation.norm() == Approx(1.0).epsilon(1e-12));
    mean += rotation.toRotationMatrix() / draws;
    half_turns += rotation.toRotationMatrix().trace() < 1 ? 1 : 0;  // an angle above 90 degrees
  }
  CHECK(mean.norm() < 0.03);
  // The angle has the density (1 - cos a) / pi: above 90 degrees is a share of 1/2 + 1/pi.
  CHECK(std::abs(half_turns / static_cast<double>(draws) - 0.5 - std::numbers::inv_pi) < 0.01);
}

}  // namespace mdbd::test
