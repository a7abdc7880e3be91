#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "features/core/triangle.h"
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
  const TriangleCorners* piece = nullptr;  ///< contains center; only with radius 0

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
  CubeBound bound_over_cube(const Eigen::Vector3d& x, double half_size) const {
    // A piece that is small for the cube says no more than a point, which is cheaper.
    if (piece != nullptr && piece_is_within(0.5 * half_size)) {
      return Witness{center}.bound_over_cube(x, half_size);
    }
    CubeBound bound{-std::numeric_limits<double>::infinity(), linearise(x)};
    bound.model.offset = bound.largest;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d offset((corner & 1) != 0 ? half_size : -half_size,
                                   (corner & 2) != 0 ? half_size : -half_size,
                                   (corner & 4) != 0 ? half_size : -half_size);
      const double corner_value = value(x + offset);
      bound.largest = std::max(bound.largest, corner_value);
      bound.model.offset =
          std::max(bound.model.offset, corner_value - bound.model.slope.dot(offset));
    }
    return bound;
  }

 private:
  bool piece_is_within(double distance) const {
    return std::all_of(piece->begin(), piece->end(), [&](const Eigen::Vector3d& corner) {
      return (corner - center).squaredNorm() <= distance * distance;
    });
  }

  Eigen::Vector3d closest(const Eigen::Vector3d& x) const {
    return piece != nullptr ? closest_point(*piece, x) : center;
  }
};

}  // namespace mdbd
