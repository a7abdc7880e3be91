#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "features/core/ball.h"

namespace mdbd {

/// Why a decomposition ended.
enum class Termination {
  ball_count,      ///< the number of balls asked for was placed
  minimum_radius,  ///< every ball still possible is smaller than the minimum radius
  empty_interior,  ///< no ball at all: the boundary encloses nothing of the minimum radius
  cell_limit       ///< the search had no room for more cells, and found no further ball
};

std::string_view to_string(Termination termination);

/// What a decomposition cost, in counted events: the same on every machine.
struct DecompositionCost {
  std::uint64_t distance_queries = 0;
  std::uint64_t cells = 0;  ///< octree cells created
};

/// Maximal disjoint balls in order of placement, with the evidence for "maximal". Object units.
struct BallDecomposition {
  std::vector<Ball> balls;
  /// upper_bounds[i]: when ball i was placed, no ball larger than this fitted. Same size as balls.
  std::vector<double> upper_bounds;
  /// Whether every ball is proved to be within the radius tolerance of the largest possible. Where
  /// the boundary has holes the upper bounds are only estimates; where the search had no room for
  /// more cells they are true, but may be beyond the tolerance.
  bool is_certified = true;
  double scale = 0.0;  ///< R, the radius of the smallest ball that encloses the boundary
  Termination termination = Termination::ball_count;
  DecompositionCost cost;
};

}  // namespace mdbd
