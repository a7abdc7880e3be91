#pragma once

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "features/core/ball.h"

/// Balls without a decomposition.
namespace mdbd::test {

/// Balls that touch at most, of widely different sizes, without any symmetry.
inline std::vector<Ball> random_balls(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> coordinate(0.0, 1.0);
  std::uniform_real_distribution<double> exponent(-5.0, -0.5);
  std::vector<Ball> balls;
  while (balls.size() < count) {
    Ball ball{{2 * coordinate(random), coordinate(random), 0.5 * coordinate(random)},
              std::exp(exponent(random))};
    bool is_free = true;
    for (const Ball& other : balls) {
      is_free = is_free && (ball.center - other.center).norm() > ball.radius + other.radius;
    }
    if (is_free) balls.push_back(ball);
  }
  return balls;
}

/// The balls of a shape that was rotated, reflected if asked for, scaled and moved.
inline std::vector<Ball> moved_balls(std::vector<Ball> balls, const Eigen::Matrix3d& turn,
                                     double scale, const Eigen::Vector3d& shift) {
  for (Ball& ball : balls) {
    ball.center = scale * (turn * ball.center) + shift;
    ball.radius *= scale;
  }
  return balls;
}

inline Eigen::Matrix3d some_rotation() {
  return Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.2, -0.7, 0.4).normalized()).toRotationMatrix();
}

}  // namespace mdbd::test
