#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace mdbd {

/// Points that are compared by L1, all of them, with vector instructions: beyond some ten
/// dimensions a tree rules out too little to be faster. Thread-safe.
class SketchList {
 public:
  /// Told of a row, gives the radius within which rows are still of interest, at most the last one.
  using Visitor = std::function<double(std::size_t row)>;

  /// @param points one after the other, `dimension` finite numbers each
  /// @pre dimension is not 0, and points is a whole number of points
  SketchList(std::span<const float> points, std::size_t dimension);

  /// Visits every row whose L1 distance from the query is at most the radius, which shrinks as the
  /// visitor says, and some others, in order.
  /// @pre the query has the dimension of the points
  void visit_within(std::span<const float> query, double radius, const Visitor& visitor) const;

 private:
  std::size_t rows_;
  std::size_t stride_;  // the dimension filled up to what vector instructions take at once
  std::vector<float> points_;
};

}  // namespace mdbd
