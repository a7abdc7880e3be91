#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "features/decomposition/max_min_program.h"

namespace mdbd {

/// A reason why no large ball fits near a point: no ball centred at x is larger than
/// |x - center| - radius. A boundary point is a witness of radius zero, a placed ball one of its
/// own radius, and so is any ball outside the solid. Object units.
struct Witness {
  Eigen::Vector3d center;
  double radius = 0.0;

  double value(const Eigen::Vector3d& x) const { return (x - center).norm() - radius; }

  /// The largest value over the axis-aligned cube of this centre and half size.
  double largest_value(const Eigen::Vector3d& cube_center, double half_size) const {
    const Eigen::Vector3d offset = (cube_center - center).cwiseAbs();
    return (offset.array() + half_size).matrix().norm() - radius;
  }

  /// The first-order model of the value around x: exact at x, below the value elsewhere.
  AffineFunction linearise(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d difference = x - center;
    const double distance = difference.norm();
    if (!(distance > 0)) return {-radius, Eigen::Vector3d::Zero()};
    return {distance - radius, difference / distance};
  }

  /// The lowest affine function with the slope of the value at x that is not below the value
  /// anywhere in the cube around x. The value is convex, so the corners decide; the error is of
  /// second order in the half size.
  AffineFunction overestimate(const Eigen::Vector3d& x, double half_size) const {
    AffineFunction model = linearise(x);
    const Eigen::Array3d difference = x - center;
    const Eigen::Array3d lower = (difference - half_size).square();
    const Eigen::Array3d upper = (difference + half_size).square();
    model.offset = -std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 8; ++corner) {
      double squared = 0.0;
      double rise = 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        const bool is_upper = (corner >> axis & 1) != 0;
        squared += is_upper ? upper[axis] : lower[axis];
        rise += is_upper ? model.slope[axis] : -model.slope[axis];
      }
      model.offset = std::max(model.offset, std::sqrt(squared) - rise * half_size);
    }
    model.offset -= radius;
    return model;
  }
};

}  // namespace mdbd
