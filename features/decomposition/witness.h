#pragma once

#include <limits>

#include <Eigen/Core>

#include "features/core/convex_polygon.h"
#include "features/decomposition/max_min_program.h"

namespace mdbd {

/// Upper bounds of a convex function over a cube; the corners decide both.
struct CubeBound {
  double largest;  ///< of all values
  /// The lowest affine function with the slope at the centre that is nowhere below the function,
  /// relative to the centre. For a distance its error is of second order in the size of the cube,
  /// and zero above a flat piece.
  AffineFunction model;
};

/// A reason why no large ball fits near a point: no ball centred at x is larger than the distance
/// of x from the witness. A witness is a boundary point, with or without a flat piece of the
/// boundary around it, or a ball that is placed or outside the solid. Object units.
///
/// The distance is a convex function: all bounds rest on that.
struct Witness {
  Eigen::Vector3d center;
  double radius = 0.0;
  ConvexPolygon piece = {};  ///< contains center; only with radius 0

  /// The distance of x from the witness, negative inside a ball.
  double value(const Eigen::Vector3d& x) const { return (x - closest(x)).norm() - radius; }

  /// The first-order model of the value around x: exact at x, not above the value elsewhere.
  AffineFunction linearise(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d difference = x - closest(x);
    const double distance = difference.norm();
    if (!(distance > 0)) return {-radius, Eigen::Vector3d::Zero()};
    return {distance - radius, difference / distance};
  }

  /// What the values over the axis-aligned cube around x are below.
  CubeBound bound_over_cube(const Eigen::Vector3d& x, double half_size) const;

 private:
  Eigen::Vector3d closest(const Eigen::Vector3d& x) const;
};

}  // namespace mdbd
