#pragma once

#include <cstdint>

#include "features/decomposition/ball_set.h"
#include "features/decomposition/preference.h"
#include "features/distance/distance_field.h"

namespace mdbd {

/// The solid less the balls placed so far, with its field
/// d_i(x) = min( d(x), min_{j<i} |x - c_j| - r_j ) (paper, B.2). Counts its distance queries.
class RemainingSpace {
 public:
  explicit RemainingSpace(const DistanceField& field)
      : field_(field), preference_(Preference::outward(field.enclosing_ball())) {}

  /// Measures the solid alone.
  DistanceSample measure_solid(const DistanceQuery& query) {
    ++query_count_;
    return field_.measure(query);
  }

  const Preference& preference() const { return preference_; }
  /// Ranks by another preference; all ranks and their bounds from before are void.
  void prefer(const Preference& preference) { preference_ = preference; }
  bool is_closed() const { return field_.is_closed(); }
  const BallSet& balls() const { return balls_; }
  void place(const Ball& ball) { balls_.add(ball); }
  std::uint64_t query_count() const { return query_count_; }

 private:
  const DistanceField& field_;
  Preference preference_;
  BallSet balls_;
  std::uint64_t query_count_ = 0;
};

}  // namespace mdbd
