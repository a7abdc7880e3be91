#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "features/core/ball.h"
#include "features/decomposition/witness.h"

namespace mdbd {

/// The balls placed so far, laid out for fast scans. They are numbered in order of placement.
class BallSet {
 public:
  static constexpr std::size_t block_size = 16;

  std::size_t size() const { return size_; }
  void add(const Ball& ball);

  Witness witness(std::uint32_t ball) const {
    const Block& block = blocks_[ball / block_size];
    const std::size_t lane = ball % block_size;
    return {{block.x[lane], block.y[lane], block.z[lane]}, block.radius[lane]};
  }

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

  /// The distance to the nearest ball's surface, negative inside it; `limit` if that is less.
  double gap(const Eigen::Vector3d& point, double limit) const;

 private:
  /// Balls side by side; filled up with balls infinitely far away.
  struct Block {
    std::array<double, block_size> x;
    std::array<double, block_size> y;
    std::array<double, block_size> z;
    std::array<double, block_size> radius;
  };

  std::size_t size_ = 0;
  std::vector<Block> blocks_;
};

}  // namespace mdbd
