#pragma once

#include <cstddef>
#include <span>

#include "features/core/ball.h"
#include "features/distance/distance_field.h"

namespace mdbd::bench {

/// How good a list of disjoint balls is, in order of placement.
struct BallQuality {
  std::size_t balls = 0;
  std::size_t contacts = 0;  ///< pairs of tangent balls, to 1e-3 of the smaller radius
  double escape = 0.0;       ///< largest (r_i - d(c_i)) / R, at least 0
  double overlap = 0.0;      ///< largest (r_i + r_j - |c_i - c_j|) / R, at least 0
  /// Largest r_j / r_i - 1 of a ball j placed after ball i, at least 0: a maximal decomposition is
  /// in decreasing order.
  double order_violation = 0.0;
  /// Mean of |r_i / s_i - 1| over the radii r and those of the reference s, both in decreasing
  /// order; a ball that only one of them has counts as an error of 1.
  double radius_error = 0.0;
};

/// Measures balls with distances alone. Quadratic in the number of balls.
/// @param reference the balls of a certified decomposition of the same field
BallQuality measure_quality(const DistanceField& field, std::span<const Ball> balls,
                            std::span<const Ball> reference);

}  // namespace mdbd::bench
