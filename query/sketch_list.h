#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "query/metric_block.h"

namespace mdbd {

/// Points that are compared by L1 or L2, all of them, with vector instructions: beyond some ten
/// dimensions a tree rules out too little to be faster, and it takes long to build. Thread-safe.
///
/// In memory and in files they lie in groups of 8 points, the last one filled up with zeros: the
/// first numbers of all 8, then the second ones, and so on.
class SketchList {
 public:
  static constexpr std::size_t group_size = 8;

  /// Told of a row, gives the radius within which rows are still of interest, at most the last one.
  using Visitor = std::function<double(std::size_t row)>;

  /// How many numbers the groups of so many points have.
  static constexpr std::size_t grouped_size(std::size_t rows, std::size_t dimension) {
    return (rows + group_size - 1) / group_size * group_size * dimension;
  }

  /// @param points one after the other, `dimension` finite numbers each
  /// @pre dimension is not 0, and points is a whole number of points
  SketchList(std::span<const float> points, std::size_t dimension, PointNorm norm);

  /// @param groups as groups() gives them, kept by `owner`
  SketchList(std::span<const float> groups, std::size_t rows, std::size_t dimension, PointNorm norm,
             std::shared_ptr<const void> owner);

  std::span<const float> groups() const { return groups_; }
  std::size_t dimension() const { return dimension_; }

  /// All points one after the other.
  std::vector<float> points() const;

  /// Visits every row whose distance from the query is at most the radius, which shrinks as the
  /// visitor says, and some others, in order.
  /// @pre the query has the dimension of the points
  void visit_within(std::span<const float> query, double radius, const Visitor& visitor) const;

 private:
  float limit_of(double radius) const;

  std::size_t rows_;
  std::size_t dimension_;
  PointNorm norm_;
  std::span<const float> groups_;
  std::shared_ptr<const void> owner_;
};

}  // namespace mdbd
