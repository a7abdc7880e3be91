#include "features/distance/point_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

static_assert(TreeNode::width == PointBlock::width);

inline void point_distances(const PointBlock& block, const TreePoint& p, Lanes& squared) {
  for (int i = 0; i < PointBlock::width; ++i) {
    const float dx = block.coordinates[0][i] - p.x;
    const float dy = block.coordinates[1][i] - p.y;
    const float dz = block.coordinates[2][i] - p.z;
    squared[i] = dx * dx + dy * dy + dz * dz;
  }
}

/// The closest point so far: what single precision does not rule out is measured in double.
class Closest {
 public:
  /// @param margin by how much a distance in single precision may be off, in tree coordinates
  Closest(const PointTree& tree, const Eigen::Vector3d& point, double bound, double margin)
      : tree_(tree), point_(point), margin_(margin) {
    set_reach(bound * tree.inverse_extent());
  }

  /// What is farther, squared and in tree coordinates, is not closest.
  float reach() const { return reach_; }
  std::uint32_t best() const { return best_; }

  void offer(std::uint32_t candidate) {
    const double squared = (tree_.points()[candidate] - point_).squaredNorm();
    if (squared >= best_squared_) return;
    best_squared_ = squared;
    best_ = candidate;
    set_reach(std::sqrt(squared) * tree_.inverse_extent());
  }

 private:
  void set_reach(double distance) {
    const double reach = distance + margin_;
    reach_ = static_cast<float>(reach * reach * (1.0 + 1e-6));
  }

  const PointTree& tree_;
  const Eigen::Vector3d& point_;
  double margin_;
  float reach_ = 0.0F;
  std::uint32_t best_ = 0;
  double best_squared_ = std::numeric_limits<double>::infinity();
};

}  // namespace

PointTree::PointTree(std::span<const Eigen::Vector3d> points)
    : points_(points.begin(), points.end()), sources_(points.size()) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  const double extent = box.sizes().maxCoeff();
  origin_ = box.center();
  inverse_extent_ = extent > 0 ? 1.0 / extent : 1.0;
  std::iota(sources_.begin(), sources_.end(), 0U);
  build({0, static_cast<std::uint32_t>(points.size())});
  for (std::size_t i = 0; i < points.size(); ++i) points_[i] = points[sources_[i]];
}

std::uint32_t PointTree::build(Range range) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  const std::vector<Range> children = divide(range);
  TreeNode node;
  for (int child = 0; child < TreeNode::width; ++child) {
    const bool exists = static_cast<std::size_t>(child) < children.size();
    set_child(node, child, exists ? children[child] : Range{0, 0});
    if (!exists) continue;
    if (children[child].size() > PointBlock::width) {
      node.inner[child] = build(children[child]);
    } else {
      node.block[child] = add_block(children[child]);
    }
  }
  nodes_[number] = node;
  return number;
}

// Halves the largest part at its longest side until there are eight, or all fit into leaves.
std::vector<PointTree::Range> PointTree::divide(Range range) {
  std::vector<Range> parts{range};
  while (parts.size() < TreeNode::width) {
    const auto largest = std::ranges::max_element(parts, {}, &Range::size);
    if (largest->size() <= PointBlock::width) break;
    Eigen::AlignedBox3d box;
    for (std::uint32_t i = largest->begin; i < largest->end; ++i) box.extend(points_[sources_[i]]);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::uint32_t middle = largest->begin + largest->size() / 2;
    // The index decides between equal coordinates, so that the order is one of its own.
    std::nth_element(sources_.begin() + largest->begin, sources_.begin() + middle,
                     sources_.begin() + largest->end, [&](std::uint32_t a, std::uint32_t b) {
                       return std::pair(points_[a][axis], a) < std::pair(points_[b][axis], b);
                     });
    const Range upper{middle, largest->end};
    largest->end = middle;
    parts.push_back(upper);
  }
  return parts;
}

Eigen::Vector3f PointTree::to_tree(const Eigen::Vector3d& point) const {
  return ((point - origin_) * inverse_extent_).cast<float>();
}

void PointTree::set_child(TreeNode& node, int child, Range range) const {
  Eigen::AlignedBox3f box;
  for (std::uint32_t i = range.begin; i < range.end; ++i) box.extend(to_tree(points_[sources_[i]]));
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    node.lower[axis][child] = range.size() > 0 ? box.min()[axis] : infinity;
    node.upper[axis][child] = range.size() > 0 ? box.max()[axis] : -infinity;
  }
  node.first[child] = range.begin;
  node.count[child] = range.size();
  node.inner[child] = 0;
  node.block[child] = 0;
}

std::uint32_t PointTree::add_block(Range range) {
  PointBlock block;
  for (std::uint32_t i = 0; i < PointBlock::width; ++i) {
    const Eigen::Vector3f point =
        to_tree(points_[sources_[std::min(range.begin + i, range.end - 1)]]);
    for (int axis = 0; axis < 3; ++axis) block.coordinates[axis][i] = point[axis];
  }
  blocks_.push_back(block);
  return static_cast<std::uint32_t>(blocks_.size() - 1);
}

MDBD_VECTORISED
std::uint32_t PointTree::find_closest(const Eigen::Vector3d& point, double bound) const {
  const Eigen::Vector3d local = (point - origin_) * inverse_extent_;
  const TreePoint p{static_cast<float>(local.x()), static_cast<float>(local.y()),
                    static_cast<float>(local.z())};
  Closest closest(*this, point, bound, 1e-6 * (1.0 + local.lpNorm<Eigen::Infinity>()));
  visit_leaves_within<max_stack_size>(
      nodes_, p, [&] { return closest.reach(); },
      [&](const TreeLeaf& leaf) MDBD_PART_OF_CALLER {
        alignas(32) Lanes squared;
        point_distances(blocks_[leaf.block], p, squared);
        for (std::uint32_t i = 0; i < leaf.count; ++i) {
          if (squared[i] <= closest.reach()) closest.offer(leaf.first + i);
        }
      });
  return closest.best();
}

}  // namespace mdbd
