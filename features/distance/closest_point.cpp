#include "features/distance/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "features/core/triangle.h"
#include "features/core/vectorised.h"

namespace mdbd {
namespace {

static_assert(TreeNode::width == TriangleBlock::width);

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
inline void triangle_distances(const TriangleBlock& block, const TreePoint& p, Lanes& squared) {
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
  const TreePoint p{static_cast<float>(local.x()), static_cast<float>(local.y()),
                    static_cast<float>(local.z())};
  const double margin = 1e-6 * (1.0 + local.lpNorm<Eigen::Infinity>());
  Candidates candidates(bound * tree.inverse_extent(), margin);
  const TriangleBlock* const blocks = tree.blocks().data();
  ClosestPoint best{point, std::numeric_limits<double>::infinity(), 0};
  visit_leaves_within<TriangleTree::max_stack_size>(
      tree.nodes(), p, [&] { return candidates.reach(); },
      [&](const TreeLeaf& leaf) MDBD_PART_OF_CALLER {
        alignas(32) Lanes squared;
        triangle_distances(blocks[leaf.block], p, squared);
        if (smallest(squared) > candidates.reach()) return;
        for (std::uint32_t i = 0; i < leaf.count; ++i) {
          if (candidates.is_full()) candidates.resolve(tree, point, best);
          candidates.offer(leaf.first + i, squared[i]);
        }
      });
  candidates.resolve(tree, point, best);
  return best;
}

MDBD_VECTORISED
void find_near_triangles(const TriangleTree& tree, const Eigen::Vector3d& point, double slack,
                         double bound, std::vector<ClosestPoint>& found) {
  const Eigen::Vector3d local = (point - tree.origin()) * tree.inverse_extent();
  const TreePoint p{static_cast<float>(local.x()), static_cast<float>(local.y()),
                    static_cast<float>(local.z())};
  const double margin =
      1e-6 * (1.0 + local.lpNorm<Eigen::Infinity>()) + slack * tree.inverse_extent();
  const TriangleBlock* const blocks = tree.blocks().data();
  // As with Candidates: what is farther, squared, is not near.
  const auto reach_of = [&](double distance) {
    const auto reach = static_cast<float>(distance + margin);
    return reach * reach * (1.0F + 1e-6F);
  };
  float reach = reach_of(bound * tree.inverse_extent());
  double nearest = std::numeric_limits<double>::infinity();
  found.clear();
  visit_leaves_within<TriangleTree::max_stack_size>(
      tree.nodes(), p, [&] { return reach; },
      [&](const TreeLeaf& leaf) MDBD_PART_OF_CALLER {
        alignas(32) Lanes squared;
        triangle_distances(blocks[leaf.block], p, squared);
        if (smallest(squared) > reach) return;
        for (std::uint32_t i = 0; i < leaf.count; ++i) {
          if (squared[i] > reach) continue;
          const std::uint32_t triangle = leaf.first + i;
          const Eigen::Vector3d candidate = closest_point(tree.triangles()[triangle], point);
          const double exact = (candidate - point).squaredNorm();
          found.push_back({candidate, exact, triangle});
          if (exact >= nearest) continue;
          nearest = exact;
          reach = std::min(reach, reach_of(std::sqrt(nearest) * tree.inverse_extent()));
        }
      });
  const double limit = std::sqrt(nearest) + slack;
  std::erase_if(found, [&](const ClosestPoint& c) { return c.squared_distance > limit * limit; });
  std::ranges::sort(found, [](const ClosestPoint& a, const ClosestPoint& b) {
    return std::pair(a.squared_distance, a.triangle) < std::pair(b.squared_distance, b.triangle);
  });
}

}  // namespace mdbd
