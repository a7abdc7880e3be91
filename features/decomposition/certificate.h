#pragma once

#include "features/decomposition/ball_decomposition.h"
#include "features/distance/distance_field.h"

namespace mdbd {

/// How far a decomposition is from its guarantees; the first two are relative to R.
struct Certificate {
  double containment_violation = 0.0;  ///< max over balls of (r_i - d(c_i)) / R, at least 0
  double overlap_violation = 0.0;  ///< max over pairs of (r_i + r_j - |c_i - c_j|) / R, at least 0
  double maximality_gap = 0.0;     ///< max over balls of upper_bound_i / r_i - 1
};

/// Re-checks that balls are contained and disjoint with distances alone, and sums up what the
/// search promised of their maximality. Quadratic in the number of balls.
/// @pre upper_bounds and balls have the same size; scale > 0
Certificate check_certificate(const DistanceField& field, const BallDecomposition& decomposition);

}  // namespace mdbd
