#pragma once

#include <cstdint>
#include <vector>

#include "features/core/box.h"
#include "features/core/triangle.h"
#include "features/distance/tree_node.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// The triangles of a leaf, laid out for vector instructions, [axis][triangle]: the corner where
/// the longest side begins, the unit vector along that side and the one across it in the triangle's
/// plane, in tree coordinates. In the frame of these three the corners are (0, 0), (length, 0) and
/// (apex[0], apex[1]) with apex[1] >= 0. Where a leaf has fewer triangles, its last is repeated.
struct TriangleBlock {
  static constexpr int width = 8;

  float corner[3][width];
  float along[3][width];
  float across[3][width];
  float length[width];
  float apex[2][width];

  struct FramePoint {
    float x;
    float y;
    float height;
  };

  /// A vector, in tree coordinates, in the frame of triangle i.
  MDBD_PART_OF_CALLER FramePoint in_frame(int i, float px, float py, float pz) const {
    const float ux = along[0][i];
    const float uy = along[1][i];
    const float uz = along[2][i];
    const float vx = across[0][i];
    const float vy = across[1][i];
    const float vz = across[2][i];
    return {px * ux + py * uy + pz * uz, px * vx + py * vy + pz * vz,
            px * (uy * vz - uz * vy) + py * (uz * vx - ux * vz) + pz * (ux * vy - uy * vx)};
  }
};

/// A bounding volume hierarchy over the triangles of a mesh, eight children to a node. The
/// structure that closest-point and winding-number queries share.
class TriangleTree {
 public:
  /// Enough room for the stack of any depth-first traversal: the depth of a tree is bounded.
  static constexpr int max_stack_size = 512;

  /// @pre mesh has at least one triangle
  explicit TriangleTree(const TriangleMesh& mesh);

  const std::vector<TreeNode>& nodes() const { return nodes_; }  ///< nodes()[0] is the root
  const std::vector<TriangleBlock>& blocks() const { return blocks_; }
  const std::vector<TriangleCorners>& triangles() const { return triangles_; }  ///< in leaf order
  /// The triangle of the mesh that triangles()[i] is.
  const std::vector<std::uint32_t>& sources() const { return sources_; }
  const Eigen::Vector3d& origin() const { return origin_; }
  double inverse_extent() const { return inverse_extent_; }

 private:
  struct Item;
  struct Range;

  std::uint32_t build(std::vector<Item>& items, const Range& range, int depth);
  void set_child(std::uint32_t node, int child, const Range& range);
  std::uint32_t add_block(const std::vector<Item>& items, const Range& range);

  std::vector<TreeNode> nodes_;
  std::vector<TriangleBlock> blocks_;
  std::vector<TriangleCorners> triangles_;
  std::vector<std::uint32_t> sources_;
  Eigen::Vector3d origin_;
  double inverse_extent_;
};

}  // namespace mdbd
