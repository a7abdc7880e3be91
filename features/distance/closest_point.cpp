#include "features/distance/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "features/core/triangle.h"
#include "features/core/vectorised.h"

namespace mdbd {
namespace {

/// A point in tree coordinates.
struct LocalPoint {
  float x;
  float y;
  float z;
};

struct StackEntry {
  float squared_distance;
  std::uint32_t inner;  // the node, or 0 for a leaf
  std::uint32_t block;
  std::uint32_t first;
  std::uint32_t count;
};

using Lanes = float[TreeNode::width];
static_assert(TreeNode::width == TriangleBlock::width);

/// Squared distances to the boxes of a node's children.
inline void box_distances(const TreeNode& node, const LocalPoint& p, Lanes& squared) {
  for (int c = 0; c < TreeNode::width; ++c) {
    const float dx = std::max(std::max(node.lower[0][c] - p.x, p.x - node.upper[0][c]), 0.0F);
    const float dy = std::max(std::max(node.lower[1][c] - p.y, p.y - node.upper[1][c]), 0.0F);
    const float dz = std::max(std::max(node.lower[2][c] - p.z, p.z - node.upper[2][c]), 0.0F);
    squared[c] = dx * dx + dy * dy + dz * dz;
  }
}

/// The squared distance of (x, y) from the side that runs by (side_x, side_y) from the origin.
inline float side_distance(float x, float y, float side_x, float side_y) {
  const float squared_length = side_x * side_x + side_y * side_y;
  const float along = x * side_x + y * side_y;
  const float t = std::min(
      std::max(along / std::max(squared_length, std::numeric_limits<float>::min()), 0.0F), 1.0F);
  const float dx = x - t * side_x;
  const float dy = y - t * side_y;
  return dx * dx + dy * dy;
}

/// Squared distances to the triangles of a block: from their planes, and within the planes.
inline void triangle_distances(const TriangleBlock& block, const LocalPoint& p, Lanes& squared) {
  for (int i = 0; i < TriangleBlock::width; ++i) {
    const auto [x, y, z] = block.in_frame(i, p.x - block.corner[0][i], p.y - block.corner[1][i],
                                          p.z - block.corner[2][i]);
    const float length = block.length[i];
    const float apex_x = block.apex[0][i];
    const float apex_y = block.apex[1][i];
    const float from_end = x - length;
    const float second_x = apex_x - length;
    const float nearest =
        std::min(std::min(side_distance(x, y, length, 0.0F), side_distance(x, y, apex_x, apex_y)),
                 side_distance(from_end, y, second_x, apex_y));
    const float left = x * apex_y - y * apex_x;
    const float right = second_x * y - from_end * apex_y;
    const float innermost = std::min(std::min(left, right), y);
    squared[i] = z * z + (innermost > 0.0F ? 0.0F : nearest);
  }
}

inline float smallest(const Lanes& values) {
  alignas(32) float half[TreeNode::width / 2];
  MDBD_LANES
  for (int i = 0; i < TreeNode::width / 2; ++i) {
    half[i] = std::min(values[i], values[i + TreeNode::width / 2]);
  }
  return std::min(std::min(half[0], half[1]), std::min(half[2], half[3]));
}

/// The triangles that may be closest, by their distances in single precision.
class Candidates {
 public:
  /// @param margin by how much a distance may be off
  Candidates(double bound, double margin)
      : margin_(static_cast<float>(margin)), reach_(square(static_cast<float>(bound) + margin_)) {}

  /// What is farther, squared, is not closest.
  float reach() const { return reach_; }
  bool is_full() const { return size_ == capacity; }

  /// @pre not full
  void offer(std::uint32_t triangle, float squared) {
    if (squared > reach_) return;
    candidates_[size_++] = {triangle, squared};
    reach_ = std::min(reach_, square(std::sqrt(squared) + 2.0F * margin_));
  }

  /// Finds the closest of the candidates and forgets them.
  void resolve(const TriangleTree& tree, const Eigen::Vector3d& point, ClosestPoint& best) {
    for (int i = 0; i < size_; ++i) {
      if (candidates_[i].squared > reach_) continue;
      const std::uint32_t triangle = candidates_[i].triangle;
      const Eigen::Vector3d candidate = closest_point(tree.triangles()[triangle], point);
      const double squared = (candidate - point).squaredNorm();
      if (squared < best.squared_distance) best = {candidate, squared, triangle};
    }
    size_ = 0;
  }

 private:
  static constexpr int capacity = 64;

  struct Candidate {
    std::uint32_t triangle;
    float squared;
  };

  static float square(float x) { return x * x * (1.0F + 1e-6F); }

  float margin_;
  float reach_;
  int size_ = 0;
  std::array<Candidate, capacity> candidates_;
};

}  // namespace

MDBD_VECTORISED
ClosestPoint find_closest_point(const TriangleTree& tree, const Eigen::Vector3d& point,
                                double bound) {
  const Eigen::Vector3d local = (point - tree.origin()) * tree.inverse_extent();
  const LocalPoint p{static_cast<float>(local.x()), static_cast<float>(local.y()),
                     static_cast<float>(local.z())};
  const double margin = 1e-6 * (1.0 + local.lpNorm<Eigen::Infinity>());
  Candidates candidates(bound * tree.inverse_extent(), margin);
  const TreeNode* const nodes = tree.nodes().data();
  const TriangleBlock* const blocks = tree.blocks().data();
  ClosestPoint best{point, std::numeric_limits<double>::infinity(), 0};
  std::array<StackEntry, TriangleTree::max_stack_size> stack;
  int size = 0;
  const auto push_children = [&](const TreeNode& node) {
    alignas(32) Lanes squared;
    box_distances(node, p, squared);
    const float reach = candidates.reach();
    const int begin = size;
    for (int c = 0; c < TreeNode::width; ++c) {
      if (squared[c] > reach || node.count[c] == 0) continue;
      int at = size++;
      for (; at > begin && stack[at - 1].squared_distance < squared[c]; --at) {
        stack[at] = stack[at - 1];
      }
      stack[at] = {squared[c], node.inner[c], node.block[c], node.first[c], node.count[c]};
    }
  };
  push_children(nodes[0]);
  while (size > 0) {
    const StackEntry entry = stack[--size];
    if (entry.squared_distance > candidates.reach()) continue;
    if (entry.inner != 0) {
      push_children(nodes[entry.inner]);
      continue;
    }
    alignas(32) Lanes squared;
    triangle_distances(blocks[entry.block], p, squared);
    if (smallest(squared) > candidates.reach()) continue;
    for (std::uint32_t i = 0; i < entry.count; ++i) {
      if (candidates.is_full()) candidates.resolve(tree, point, best);
      candidates.offer(entry.first + i, squared[i]);
    }
  }
  candidates.resolve(tree, point, best);
  return best;
}

}  // namespace mdbd
