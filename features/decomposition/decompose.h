#pragma once

#include "features/decomposition/ball_decomposition.h"
#include "features/distance/distance_field.h"

namespace mdbd {

/// Options of decompose().
struct DecompositionOptions {
  int balls = 500;                 ///< n, how many balls are placed at most; at least 1
  double radius_tolerance = 1e-3;  ///< epsilon, relative to the radius of the ball placed; above 0
  double minimum_radius = 1e-3;    ///< smaller balls are not placed; relative to R; above 0
  /// Bounds the memory: how many cells of the octree are kept at once, each of about 330 bytes; at
  /// least 1000. Where they do not suffice for the tolerance, as in large thin shells, the largest
  /// balls found are placed, and the upper bounds say how far they may be from the largest.
  std::size_t most_cells = 500'000;
};

/// The maximal disjoint ball decomposition of a solid (paper, section 2.2): ball i is a largest
/// ball inside the solid whose interior meets no earlier ball, that is, a global maximum of
/// d_i(x) = min( d(x), min_{j<i} |x - c_j| - r_j ) (paper, B.2).
///
/// Found by branch and bound over an octree. Each ball is contained and disjoint, a local maximum
/// to about machine precision, and within the radius tolerance of the global maximum:
/// upper_bounds[i] <= (1 + epsilon) r_i, unless the cells ran out. The result depends on the
/// arguments alone.
///
/// The choice is canonical: of all possible balls the one of the highest rank is placed, where the
/// rank is the radius, and between radii nearer than a tenth of the tolerance the place
/// (Preference), which does not depend on how the shape lies. A shape whose near-equal maxima are
/// too many to be told apart in a set amount of work gets one of them; the tolerance still holds.
/// @throws InvalidInput if an option is out of range
BallDecomposition decompose(const DistanceField& field, const DecompositionOptions& options = {});

}  // namespace mdbd
