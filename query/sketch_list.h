#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "query/metric_block.h"
#include "query/scalar_quantiser.h"

namespace mdbd {

/// Points in bytes (ScalarQuantiser) that are compared by L1 or L2, all of them, with vector
/// instructions: beyond some ten dimensions a tree rules out too little to be faster, and it takes
/// long to build. Thread-safe.
///
/// In memory and in files they lie in groups of 32 points, the last one filled up with zeros: the
/// first bytes of all 32, then the second ones, and so on.
class SketchList {
 public:
  static constexpr std::size_t group_size = 32;
  static constexpr std::size_t largest_dimension = 256;

  /// Told of a row, gives the radius within which rows are still of interest, at most the last one.
  using Visitor = std::function<double(std::size_t row)>;
  /// Told of rows that will be visited soon, unless the radius shrinks.
  using Announcement = std::function<void(std::size_t row)>;

  /// How many bytes the groups of so many points have.
  static constexpr std::size_t grouped_size(std::size_t rows, std::size_t dimension) {
    return (rows + group_size - 1) / group_size * group_size * dimension;
  }

  /// @param points one after the other, `dimension` finite numbers each; at least one
  /// @pre dimension is 1 to largest_dimension, and points is a whole number of points
  SketchList(std::span<const float> points, std::size_t dimension, PointNorm norm);

  /// What quantiser(), largest_error() and groups() of another one gave.
  /// @param owner keeps the groups
  SketchList(ScalarQuantiser quantiser, double largest_error, std::span<const std::uint8_t> groups,
             std::size_t rows, PointNorm norm, std::shared_ptr<const void> owner);

  const ScalarQuantiser& quantiser() const { return quantiser_; }
  /// How far a point is from its bytes at most, in steps.
  double largest_error() const { return largest_error_; }
  std::span<const std::uint8_t> groups() const { return groups_; }
  std::size_t dimension() const { return quantiser_.corner().size(); }

  /// The bytes of all points, one point after the other.
  std::vector<float> points() const;

  /// How far, in steps, the bytes of a point within the radius may be from the place of the query.
  double reach(double radius) const;

  /// Visits every row whose distance from the query is at most the radius, which shrinks as the
  /// visitor says, and some others. Those whose bytes are among the nearest so far, some `count`,
  /// come at once, the others at the end, the nearest first.
  /// @pre the query has the dimension of the points
  void visit_within(std::span<const float> query, double radius, std::size_t count,
                    const Visitor& visitor, const Announcement& announce = {}) const;

 private:
  ScalarQuantiser quantiser_;
  double largest_error_ = 0.0;
  std::size_t rows_;
  PointNorm norm_;
  std::span<const std::uint8_t> groups_;
  std::shared_ptr<const void> owner_;
};

}  // namespace mdbd
