#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "features/core/ball.h"
#include "features/distance/distance_field.h"

namespace mdbd::bench {

/// Grows balls inside a solid and beside the balls placed, with exact distances. Object units.
class ExactClimb {
 public:
  /// @param field is referred to
  /// @param smallest precision is not needed for balls smaller than this
  ExactClimb(const DistanceField& field, double smallest) : field_(field), smallest_(smallest) {}

  /// The distance of a point inside from the boundary.
  double measure(const Eigen::Vector3d& inside);

  /// Moves a point uphill until the ball around it hardly grows any more. Each step goes along the
  /// shortest vector in the hull of the directions away from what stopped the steps before, which
  /// is the steepest ascent of a minimum of distances (Wolfe, A method of conjugate subgradients,
  /// 1975).
  /// @param step the length of the first step
  Ball climb(const Eigen::Vector3d& inside, double step);

  void place(const Ball& ball) { balls_.push_back(ball); }
  const std::vector<Ball>& balls() const { return balls_; }
  std::uint64_t query_count() const { return query_count_; }

 private:
  /// A point inside with the ball around it.
  struct Place {
    Eigen::Vector3d point;
    double radius = 0.0;
    Eigen::Vector3d away;   // the direction away from the nearest ball or boundary point
    DistanceSample sample;  // of the boundary
  };
  struct Gap {
    double distance;
    Eigen::Vector3d center;  // of the nearest ball
  };

  Place make_place(const Eigen::Vector3d& point, const DistanceSample& sample, const Gap& gap);
  Place look(const Place& from, const Eigen::Vector3d& step);
  std::optional<Place> find_step(const Place& from, double length);
  DistanceSample query(const DistanceQuery& query);
  Gap nearest_ball(const Eigen::Vector3d& point, double limit);
  void gather_neighbours(const Eigen::Vector3d& point, double reach);

  const DistanceField& field_;
  double smallest_;
  std::vector<Ball> balls_;
  std::uint64_t query_count_ = 0;
  // All balls whose surface is nearer than `reach_` to `gathered_at_`.
  std::vector<Ball> neighbours_;
  Eigen::Vector3d gathered_at_;
  double reach_ = 0.0;
};

}  // namespace mdbd::bench
