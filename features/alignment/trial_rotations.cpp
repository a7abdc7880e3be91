#include "features/alignment/trial_rotations.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace mdbd {
namespace {

void append_rotations_of_axes(std::vector<Eigen::Matrix3d>& rotations) {
  for (int image_of_x = 0; image_of_x < 6; ++image_of_x) {
    for (int image_of_y = 0; image_of_y < 6; ++image_of_y) {
      if (image_of_x % 3 == image_of_y % 3) continue;
      const Eigen::Vector3d x = Eigen::Vector3d::Unit(image_of_x % 3) * (image_of_x < 3 ? 1 : -1);
      const Eigen::Vector3d y = Eigen::Vector3d::Unit(image_of_y % 3) * (image_of_y < 3 ? 1 : -1);
      Eigen::Matrix3d rotation;
      rotation << x, y, x.cross(y);
      rotations.push_back(rotation);
    }
  }
}

// The pair of irrational numbers that the paper recommends: phi² = 2, psi⁴ = psi + 4.
constexpr double phi = std::numbers::sqrt2;
constexpr double psi = 1.533751168755204288118041;

Eigen::Quaterniond super_fibonacci(std::size_t index, std::size_t count) {
  const double s = static_cast<double>(index) + 0.5;
  const double share = s / static_cast<double>(count);
  const double alpha = 2.0 * std::numbers::pi * s / phi;
  const double beta = 2.0 * std::numbers::pi * s / psi;
  const double r = std::sqrt(share);
  const double rest = std::sqrt(1.0 - share);
  return {rest * std::cos(beta), r * std::sin(alpha), r * std::cos(alpha), rest * std::sin(beta)};
}

}  // namespace

std::vector<Eigen::Matrix3d> trial_rotations(std::size_t count) {
  std::vector<Eigen::Matrix3d> rotations;
  rotations.reserve(24 + count);
  append_rotations_of_axes(rotations);
  for (std::size_t index = 0; index < count; ++index) {
    rotations.push_back(super_fibonacci(index, count).toRotationMatrix());
  }
  return rotations;
}

}  // namespace mdbd
