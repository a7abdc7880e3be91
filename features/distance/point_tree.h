#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "features/distance/tree_node.h"

namespace mdbd {

/// The points of a leaf in tree coordinates, [axis][point]. Where a leaf has fewer points, its last
/// is repeated.
struct PointBlock {
  static constexpr int width = 8;

  float coordinates[3][width];
};

/// A bounding volume hierarchy over points, eight children to a node, divided at medians.
class PointTree {
 public:
  /// Enough room for the stack of any depth-first traversal: medians bound the depth.
  static constexpr int max_stack_size = 256;

  /// @pre at least one point, fewer than 2^32
  explicit PointTree(std::span<const Eigen::Vector3d> points);

  const std::vector<TreeNode>& nodes() const { return nodes_; }  ///< nodes()[0] is the root
  const std::vector<PointBlock>& blocks() const { return blocks_; }
  const std::vector<Eigen::Vector3d>& points() const { return points_; }  ///< in leaf order
  /// The index in the constructor's points of points()[i].
  const std::vector<std::uint32_t>& sources() const { return sources_; }
  const Eigen::Vector3d& origin() const { return origin_; }
  double inverse_extent() const { return inverse_extent_; }

  /// The number in points() of a point that is closest, exact but for the rounding of doubles.
  /// @param bound an upper bound of the distance, which must be true; infinity if nothing is known
  std::uint32_t find_closest(const Eigen::Vector3d& point,
                             double bound = std::numeric_limits<double>::infinity()) const;

 private:
  struct Range {
    std::uint32_t begin;
    std::uint32_t end;

    std::uint32_t size() const { return end - begin; }
  };

  std::uint32_t build(Range range);
  std::vector<Range> divide(Range range);
  void set_child(TreeNode& node, int child, Range range) const;
  std::uint32_t add_block(Range range);
  Eigen::Vector3f to_tree(const Eigen::Vector3d& point) const;

  std::vector<TreeNode> nodes_;
  std::vector<PointBlock> blocks_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::uint32_t> sources_;
  Eigen::Vector3d origin_;
  double inverse_extent_;
};

}  // namespace mdbd
