#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "query/metric_block.h"

namespace mdbd {

/// Points in FLANN's hierarchical k-means tree, which finds most of the nearest. Built by one
/// thread from a fixed seed: the same points give the same tree and the same answers. Thread-safe
/// once built.
class ClusterTree {
 public:
  /// @param points one after the other, `dimension` finite numbers each
  /// @pre dimension is not 0, and points is a whole number of points, at least one
  ClusterTree(std::vector<float> points, std::size_t dimension, PointNorm norm);
  ~ClusterTree();
  ClusterTree(ClusterTree&&) noexcept;
  ClusterTree& operator=(ClusterTree&&) noexcept;

  /// Rows near a point: mostly the nearest ones, as many as asked for or all if there are fewer.
  /// @param checks how many rows are compared at least
  std::vector<std::size_t> find_near(std::span<const float> point, std::size_t count,
                                     int checks) const;

 private:
  struct Index;
  std::vector<float> points_;
  std::unique_ptr<Index> index_;
};

}  // namespace mdbd
