#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace mdbd {

/// Points of a few dimensions in FLANN's single kd-tree, which is exact and the same at every run;
/// compared by L2. Thread-safe once built.
class SketchTree {
 public:
  /// Told of a row, gives the radius within which rows are still of interest, at most the last one.
  using Visitor = std::function<double(std::size_t row)>;

  /// @param points one after the other, `dimension` finite numbers each; at least one point
  /// @throws InvalidInput if dimension is 0 or points is no whole number of points
  SketchTree(std::vector<float> points, std::size_t dimension);
  ~SketchTree();
  SketchTree(SketchTree&&) noexcept;
  SketchTree& operator=(SketchTree&&) noexcept;

  /// Visits every row whose L2 distance from the query is at most the radius, which shrinks as the
  /// visitor says, and some others; the nearest come early, in no strict order.
  /// @pre the query has the dimension of the points
  void visit_within(std::span<const float> query, double radius, const Visitor& visitor) const;

 private:
  struct Index;
  std::unique_ptr<Index> index_;
};

}  // namespace mdbd
