#pragma once

#include "features/decomposition/remaining_space.h"

namespace mdbd {

/// A local maximum of the rank: a ball that cannot grow, nor slide to a preferred place, by moving
/// a little.
struct LocalMaximum {
  Ball ball;
  double rank = 0.0;  ///< see Preference
  /// Proved: no centre within this distance has a higher rank (but for the relative tolerance
  /// `contact_accuracy`). Zero if the ball can slide.
  double basin_radius = 0.0;
};

/// Witnesses whose values differ by less than this, relative to the radius, count as touching.
inline constexpr double contact_accuracy = 1e-7;

/// Climbs from a point to a local maximum of the rank. In each step the witnesses met so far are
/// linearised and the linear programme over a trust region says where to go; witnesses bound d_i
/// from above, so where the programme promises nothing more there is nothing more to first order.
/// @param start a point inside the remaining space
/// @param step the size of the first trust region, object units
/// @param precision stops when less than this is to be gained, object units
LocalMaximum find_local_maximum(RemainingSpace& space, const Eigen::Vector3d& start, double step,
                                double precision);

/// The radius of the largest ball around the origin inside the convex hull of unit vectors; zero if
/// the origin is not inside. With the directions away from its contacts, it says how firmly a ball
/// is held: d_i falls by at least this much per unit of distance, to first order.
double hold_strength(std::span<const Eigen::Vector3d> directions);

}  // namespace mdbd
