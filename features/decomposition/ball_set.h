#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "features/core/ball.h"
#include "features/decomposition/witness.h"

namespace mdbd {

/// The balls placed so far, laid out for fast scans.
class BallSet {
 public:
  std::size_t size() const { return radius_.size(); }
  void add(const Ball& ball);

  /// Finds the balls whose surface is nearest to a point and not farther than `limit`: nearest
  /// first, ties in order of placement.
  /// @param nearest receives them; its size is the number wanted
  /// @returns the number found
  std::size_t find_nearest(const Eigen::Vector3d& point, double limit,
                           std::span<Witness> nearest) const;

  /// The distance to the nearest ball's surface, negative inside it; infinity without balls.
  double gap(const Eigen::Vector3d& point) const;

 private:
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> z_;
  std::vector<double> radius_;
};

}  // namespace mdbd
