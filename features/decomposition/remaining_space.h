#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "features/decomposition/ball_set.h"
#include "features/decomposition/flat_pieces.h"
#include "features/decomposition/preference.h"
#include "features/distance/distance_field.h"

namespace mdbd {

/// The solid less the balls placed so far, with its field
/// d_i(x) = min( d(x), min_{j<i} |x - c_j| - r_j ) (paper, B.2). Counts its distance queries.
class RemainingSpace {
 public:
  RemainingSpace(const DistanceField& field, const Preference& preference)
      : field_(field),
        preference_(preference),
        enclosing_(field.enclosing_ball()),
        balls_(enclosing_) {}

  /// Measures the solid alone.
  DistanceSample measure_solid(DistanceQuery query) {
    ++query_count_;
    // A field that errs must not lead a climb away from the shape.
    const double reach = enclosing_.radius * (1.0 + 1e-9);
    if ((query.point - enclosing_.center).squaredNorm() > reach * reach) query.side = Side::outside;
    return field_.measure(query);
  }

  /// What a sample tells, with its flat piece, if it has one.
  /// @returns a witness that is valid as long as this object
  Witness witness_of(const DistanceSample& sample) {
    return {sample.closest, 0.0, pieces_.around(sample)};
  }

  /// The same without the piece where it is so small for the distance that it tells little more
  /// than its point.
  Witness simple_witness_of(const DistanceSample& sample) {
    return is_large(sample) ? witness_of(sample) : Witness{sample.closest};
  }

  const Preference& preference() const { return preference_; }
  /// Ranks by another preference; all ranks and their bounds from before are void.
  void prefer(const Preference& preference) { preference_ = preference; }
  Eigen::Vector3d centroid() const { return field_.centroid(); }
  bool is_closed() const { return field_.is_closed(); }
  bool is_planar() const { return field_.dimension() == 2; }
  /// The point of the domain's plane below a point, if it has one.
  Eigen::Vector3d in_domain(const Eigen::Vector3d& point) const {
    return is_planar() ? Eigen::Vector3d(point.x(), point.y(), 0.0) : point;
  }
  const BallSet& balls() const { return balls_; }
  /// @param bound no ball that is placed later is larger
  void place(const Ball& ball, double bound) { balls_.add(ball, bound); }
  std::uint64_t query_count() const { return query_count_; }

 private:
  static bool is_large(const DistanceSample& sample) {
    constexpr double least_extent = 0.1;
    const double least = least_extent * std::abs(sample.distance);
    if (sample.flat_region.radius > least) return true;
    return std::ranges::any_of(sample.piece, [&](const Eigen::Vector3d& corner) {
      return (corner - sample.closest).squaredNorm() > least * least;
    });
  }

  const DistanceField& field_;
  Preference preference_;
  Ball enclosing_;
  BallSet balls_;
  FlatPieces pieces_;
  std::uint64_t query_count_ = 0;
};

}  // namespace mdbd
