#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "features/core/ball.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Options of recheck_balls(). With the defaults the search reaches about seven of eight balls of
/// real models.
struct RecheckOptions {
  int samples = 600;          ///< points drawn where larger balls are looked for
  int samples_per_ball = 12;  ///< further ones around each ball, once it is placed
  int climbs = 4;             ///< samples that climb when a ball is re-checked
  int climb_trials = 160;     ///< places tried by one climb
  std::uint64_t seed = 1;
};

/// The worst of something, and the ball that it was found at.
struct Violation {
  double size = 0.0;
  std::size_t ball = 0;  ///< counted from 0; one beyond the last: see RecheckedBalls::excess
};

/// What re-checking a decomposition found.
struct RecheckedBalls {
  Violation escape;   ///< largest (r_i - d(c_i)) / R: how far a ball leaves the solid, at least 0
  Violation overlap;  ///< largest (r_i + r_j - |c_i - c_j|) / R of two balls, at least 0
  /// Largest r / r_i - 1 of a ball of radius r that was found to fit when ball i was placed; below
  /// 0 if none that is larger was found. One beyond the last ball stands for the smallest ball
  /// allowed, where a decomposition has fewer balls than were asked for.
  Violation excess;
  /// The share of balls for which the search, which knows earlier balls only, met a ball of at
  /// least 99 % of the size: how much it means that none is larger.
  double search_reach = 0.0;
};

/// Re-checks that balls are contained, disjoint and maximal, sharing no code with the
/// decomposition.
///
/// Containment and disjointness are measured. Maximality is only tested: from seeded random points
/// inside, and from each ball's own centre, it climbs for a larger ball that fits beside the
/// earlier ones. Finding none proves nothing; the proof is the search's own bound.
/// Where the surface has holes, "inside" is only where the winding number exceeds one half.
/// @param scale R, object units, above 0
/// @param minimum_radius of the balls that may be missing, relative to R; 0 if none is missing
/// @pre mesh.triangles and balls are not empty
RecheckedBalls recheck_balls(const TriangleMesh& mesh, std::span<const Ball> balls, double scale,
                             double minimum_radius, const RecheckOptions& options);

}  // namespace mdbd
