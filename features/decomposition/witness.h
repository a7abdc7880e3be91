#pragma once

#include <cmath>

#include <Eigen/Core>

#include "features/decomposition/max_min_program.h"

namespace mdbd {

/// A reason why no large ball fits near a point: no ball centred at x is larger than
/// |x - center| - radius. A boundary point is a witness of radius zero, a placed ball one of its
/// own radius. Object units.
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

  /// An affine function that is not below the value anywhere in the cube around x, from
  /// |D n + s| <= D + n . s + |s|^2 / (2 D); its error is of second order in the half size.
  AffineFunction overestimate(const Eigen::Vector3d& x, double half_size) const {
    AffineFunction model = linearise(x);
    const double distance = model.offset + radius;
    const double diagonal = std::sqrt(3.0) * half_size;
    if (distance <= 0.5 * diagonal) return {largest_value(x, half_size), Eigen::Vector3d::Zero()};
    model.offset += diagonal * diagonal / (2.0 * distance);
    return model;
  }
};

}  // namespace mdbd
