#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "features/core/vectorised.h"

namespace mdbd {

/// The children of a node of a bounding volume hierarchy over triangles or points, laid out for
/// vector instructions, [axis][child].
///
/// Bounds are in tree coordinates: (object - origin) * inverse_extent, so that they are about 1 in
/// size whatever the units of the object. lower and upper enclose the elements below a child; one
/// that does not exist has an empty box (lower = +inf, upper = -inf).
struct TreeNode {
  static constexpr int width = 8;

  float lower[3][width];
  float upper[3][width];
  /// The elements below child c are first[c] … first[c] + count[c] - 1.
  std::uint32_t first[width];
  std::uint32_t count[width];
  std::uint32_t inner[width];  ///< the node of child c, or 0 if it is a leaf
  std::uint32_t block[width];  ///< the block with the elements of child c, if it is a leaf
};

/// One number for each child of a node, or for each element of a block.
using Lanes = float[TreeNode::width];

/// A point in tree coordinates.
struct TreePoint {
  float x;
  float y;
  float z;
};

/// A child of a node that is a leaf.
struct TreeLeaf {
  std::uint32_t block;
  std::uint32_t first;
  std::uint32_t count;
};

/// Squared distances to the boxes of a node's children.
inline void box_distances(const TreeNode& node, const TreePoint& p, Lanes& squared) {
  for (int c = 0; c < TreeNode::width; ++c) {
    const float dx = std::max(std::max(node.lower[0][c] - p.x, p.x - node.upper[0][c]), 0.0F);
    const float dy = std::max(std::max(node.lower[1][c] - p.y, p.y - node.upper[1][c]), 0.0F);
    const float dz = std::max(std::max(node.lower[2][c] - p.z, p.z - node.upper[2][c]), 0.0F);
    squared[c] = dx * dx + dy * dy + dz * dz;
  }
}

/// Visits the leaves whose boxes are within reach of a point, depth first, of the children of a
/// node the nearest first.
/// @tparam stack_size enough for any depth-first traversal of the tree
/// @param nodes the first is the root
/// @param reach reach() is the largest squared distance that matters; visits may lower it
/// @param visit called with each TreeLeaf; MDBD_PART_OF_CALLER if it is to be vectorised
template <std::size_t stack_size, typename Reach, typename Visitor>
MDBD_PART_OF_CALLER inline void visit_leaves_within(std::span<const TreeNode> nodes,
                                                    const TreePoint& p, const Reach& reach,
                                                    const Visitor& visit) {
  struct Entry {
    float squared_distance;
    std::uint32_t child;  // number of the node * width + that of its child
  };
  std::array<Entry, stack_size> stack;
  std::size_t size = 0;
  const auto push_children = [&](std::uint32_t node) MDBD_PART_OF_CALLER {
    alignas(32) Lanes squared;
    box_distances(nodes[node], p, squared);
    // A child that does not exist is infinitely far.
    const float limit = std::min(reach(), std::numeric_limits<float>::max());
    const std::size_t begin = size;
    for (std::uint32_t c = 0; c < TreeNode::width; ++c) {
      if (squared[c] > limit) continue;
      std::size_t at = size++;
      for (; at > begin && stack[at - 1].squared_distance < squared[c]; --at) {
        stack[at] = stack[at - 1];
      }
      stack[at] = {squared[c], node * TreeNode::width + c};
    }
  };
  push_children(0);
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.squared_distance > reach()) continue;
    const TreeNode& node = nodes[entry.child / TreeNode::width];
    const std::uint32_t c = entry.child % TreeNode::width;
    if (node.inner[c] != 0) {
      push_children(node.inner[c]);
    } else {
      visit(TreeLeaf{node.block[c], node.first[c], node.count[c]});
    }
  }
}

}  // namespace mdbd
