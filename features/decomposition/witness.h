#pragma once

#include <Eigen/Core>

#include "features/decomposition/flat_piece.h"
#include "features/decomposition/max_min_program.h"

namespace mdbd {

/// A reason why no large ball fits near a point: no ball centred at x is larger than the distance
/// of x from the witness. A witness is a boundary point, with or without a flat piece of the
/// boundary around it, or a ball that is placed or outside the solid. Object units.
///
/// The distance is a convex function: all bounds rest on that.
struct Witness {
  Eigen::Vector3d center;
  double radius = 0.0;
  const FlatPiece* piece = nullptr;  ///< contains center; only with radius 0

  /// The distance of x from the witness, negative inside a ball.
  double value(const Eigen::Vector3d& x) const { return linearise(x).offset; }

  /// The first-order model of the value around x: exact at x, not above the value elsewhere.
  /// @param margin a flat piece counts as so much larger, see FlatPiece::linearise()
  AffineFunction linearise(const Eigen::Vector3d& x, double margin = 0.0) const {
    if (piece != nullptr) return piece->linearise(x, margin);
    const Eigen::Vector3d difference = x - center;
    const double distance = difference.norm();
    if (!(distance > 0)) return {-radius, Eigen::Vector3d::Zero()};
    return {distance - radius, difference / distance};
  }
};

}  // namespace mdbd
