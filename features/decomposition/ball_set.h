#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "features/core/ball.h"
#include "features/decomposition/witness.h"

namespace mdbd {

/// The balls placed so far, numbered in order of placement, with lists of those that matter in each
/// part of space. A ball matters where its surface is nearer than its reach, that is, where it may
/// limit a later ball; elsewhere it may be missing from the answers. Object units.
class BallSet {
 public:
  /// @param domain a ball that encloses all points that are asked for; what lies outside belongs to
  ///        the nearest part of space
  explicit BallSet(const Ball& domain);

  std::size_t size() const { return balls_.size(); }

  /// @param reach no later ball is larger than this
  void add(const Ball& ball, double reach);

  Witness witness(std::uint32_t ball) const { return {balls_[ball].center, balls_[ball].radius}; }

  /// Finds the balls whose surface is nearest to a point and not farther than `limit`: nearest
  /// first, ties in order of placement.
  /// @param nearest receives their numbers; its size is the number wanted, at most 16
  /// @returns the number found
  std::size_t find_nearest(const Eigen::Vector3d& point, double limit,
                           std::span<std::uint32_t> nearest) const {
    return update_nearest(point, limit, 0, nearest, 0);
  }

  /// The same among the first `known` of `nearest` and the balls from number `first` on, which is
  /// faster: for a point close to one whose nearest balls were found when `first` balls were there.
  std::size_t update_nearest(const Eigen::Vector3d& point, double limit, std::size_t first,
                             std::span<std::uint32_t> nearest, std::size_t known) const;

  /// Whether the surface of any ball from number `first` on is not farther than `limit`.
  bool has_near(const Eigen::Vector3d& point, double limit, std::size_t first) const;

  /// Whether a ball overlaps none of those from number `first` on, whatever their reach.
  bool is_clear(const Ball& ball, std::size_t first) const;

 private:
  static constexpr int parts = 32;  // of the domain, along each axis

  int part_along(int axis, double coordinate) const;
  /// The balls that matter in the part of space around a point, in order of placement.
  std::span<const std::uint32_t> balls_around(const Eigen::Vector3d& point) const;

  Eigen::Vector3d corner_;
  double part_size_;
  std::vector<Ball> balls_;
  std::vector<std::vector<std::uint32_t>> lists_;  // of all parts, x fastest
};

}  // namespace mdbd
