#include "features/distance/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mdbd {
namespace {

constexpr std::uint32_t max_leaf_size = 4;
constexpr int bin_count = 16;
// Below this depth ranges are halved, which bounds the depth of any tree and the stack of a query.
constexpr int max_heuristic_depth = 40;

using FloatBox = Eigen::AlignedBox3f;

float half_area(const FloatBox& box) {
  if (box.isEmpty()) return 0.0F;
  const Eigen::Vector3f size = box.sizes();
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

// The smallest float box that encloses a box of doubles.
FloatBox round_outward(const Box& box) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  FloatBox rounded;
  for (int axis = 0; axis < 3; ++axis) {
    rounded.min()[axis] = std::nextafter(static_cast<float>(box.min()[axis]), -infinity);
    rounded.max()[axis] = std::nextafter(static_cast<float>(box.max()[axis]), infinity);
  }
  return rounded;
}

}  // namespace

struct TriangleTree::Item {
  FloatBox box;
  Eigen::Vector3f center;
  TriangleCorners corners;
  std::uint32_t source;
};

struct TriangleTree::Range {
  std::uint32_t begin;
  std::uint32_t end;
  FloatBox box;
  std::uint32_t size() const { return end - begin; }
};

namespace {

template <typename Items, typename Range>
Range make_range(const Items& items, std::uint32_t begin, std::uint32_t end) {
  Range range{begin, end, FloatBox()};
  for (std::uint32_t i = begin; i < end; ++i) range.box.extend(items[i].box);
  return range;
}

// A division of a range by the surface area heuristic: items whose bin along the axis is below
// `bin` go left.
struct Division {
  int axis = -1;
  int bin = 0;
  float cost = std::numeric_limits<float>::infinity();
};

struct Binning {
  float lower;
  float scale;
  int bin_of(float center) const {
    return std::clamp(static_cast<int>((center - lower) * scale), 0, bin_count - 1);
  }
};

Binning make_binning(const FloatBox& centers, int axis) {
  const float size = centers.sizes()[axis];
  return {centers.min()[axis], size > 0 ? bin_count / size : 0.0F};
}

template <typename Items, typename Range>
Division best_division(const Items& items, const Range& range, const FloatBox& centers) {
  Division best;
  for (int axis = 0; axis < 3; ++axis) {
    if (centers.sizes()[axis] <= 0) continue;
    const Binning binning = make_binning(centers, axis);
    std::array<FloatBox, bin_count> boxes;
    std::array<int, bin_count> counts{};
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const int bin = binning.bin_of(items[i].center[axis]);
      boxes[bin].extend(items[i].box);
      ++counts[bin];
    }
    std::array<float, bin_count> right_cost{};
    FloatBox box;
    int count = 0;
    for (int bin = bin_count - 1; bin > 0; --bin) {
      box.extend(boxes[bin]);
      count += counts[bin];
      right_cost[bin] = half_area(box) * static_cast<float>(count);
    }
    box.setEmpty();
    count = 0;
    for (int bin = 1; bin < bin_count; ++bin) {
      box.extend(boxes[bin - 1]);
      count += counts[bin - 1];
      const float cost = half_area(box) * static_cast<float>(count) + right_cost[bin];
      if (count > 0 && cost < best.cost) best = {axis, bin, cost};
    }
  }
  return best;
}

// Reorders the items of a range and returns where its right part begins.
template <typename Items, typename Range>
std::uint32_t divide(Items& items, const Range& range, int depth) {
  const std::uint32_t middle = range.begin + range.size() / 2;
  if (depth > max_heuristic_depth) return middle;
  FloatBox centers;
  for (std::uint32_t i = range.begin; i < range.end; ++i) centers.extend(items[i].center);
  const Division division = best_division(items, range, centers);
  if (division.axis < 0) return middle;
  const Binning binning = make_binning(centers, division.axis);
  const auto boundary = std::stable_partition(
      items.begin() + range.begin, items.begin() + range.end,
      [&](const auto& item) { return binning.bin_of(item.center[division.axis]) < division.bin; });
  const auto split = static_cast<std::uint32_t>(boundary - items.begin());
  return split == range.begin || split == range.end ? middle : split;
}

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  Box bounds;
  for (const Eigen::Vector3d& vertex : mesh.vertices) bounds.extend(vertex);
  origin_ = bounds.center();
  const double extent = 0.5 * bounds.sizes().maxCoeff();
  inverse_extent_ = extent > 0 ? 1.0 / extent : 1.0;

  std::vector<Item> items(mesh.triangles.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    Box box;
    for (int corner = 0; corner < 3; ++corner) {
      items[i].corners[corner] = mesh.vertices[mesh.triangles[i][corner]];
      box.extend((items[i].corners[corner] - origin_) * inverse_extent_);
    }
    items[i].box = round_outward(box);
    items[i].center = items[i].box.center();
    items[i].source = static_cast<std::uint32_t>(i);
  }
  nodes_.reserve(items.size() / 2 + 1);
  const auto count = static_cast<std::uint32_t>(items.size());
  build(items, make_range<std::vector<Item>, Range>(items, 0, count), 0);
  triangles_.reserve(items.size());
  sources_.reserve(items.size());
  for (const Item& item : items) {
    triangles_.push_back(item.corners);
    sources_.push_back(item.source);
  }
}

std::uint32_t TriangleTree::build(std::vector<Item>& items, const Range& range, int depth) {
  std::vector<Range> children{range};
  while (children.size() < TreeNode::width) {
    const auto largest =
        std::max_element(children.begin(), children.end(), [](const Range& a, const Range& b) {
          const bool a_is_leaf = a.size() <= max_leaf_size;
          const bool b_is_leaf = b.size() <= max_leaf_size;
          if (a_is_leaf != b_is_leaf) return a_is_leaf;
          return half_area(a.box) < half_area(b.box);
        });
    if (largest->size() <= max_leaf_size) break;
    const Range whole = *largest;
    const std::uint32_t middle = divide(items, whole, depth);
    *largest = make_range<std::vector<Item>, Range>(items, whole.begin, middle);
    children.push_back(make_range<std::vector<Item>, Range>(items, middle, whole.end));
  }
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  for (int child = 0; child < TreeNode::width; ++child) {
    if (child < static_cast<int>(children.size())) {
      set_child(node, child, children[child]);
      if (children[child].size() > max_leaf_size) {
        const std::uint32_t inner = build(items, children[child], depth + 1);
        nodes_[node].inner[child] = inner;
      }
    } else {
      set_child(node, child, Range{0, 0, FloatBox()});
    }
  }
  return node;
}

void TriangleTree::set_child(std::uint32_t node, int child, const Range& range) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    nodes_[node].lower[axis][child] = range.size() > 0 ? range.box.min()[axis] : infinity;
    nodes_[node].upper[axis][child] = range.size() > 0 ? range.box.max()[axis] : -infinity;
  }
  nodes_[node].first[child] = range.begin;
  nodes_[node].count[child] = range.size();
  nodes_[node].inner[child] = 0;
}

namespace {

// A point as the tree's boxes see it: a small margin around it makes up for the rounding of its
// coordinates and of the box tests, so that no box is ever left out wrongly.
struct BoxQuery {
  float lower[3];
  float upper[3];

  BoxQuery(const TriangleTree& tree, const Eigen::Vector3d& point) {
    const Eigen::Vector3d local = (point - tree.origin()) * tree.inverse_extent();
    const double margin = 4e-7 * (1.0 + local.lpNorm<Eigen::Infinity>());
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = static_cast<float>(local[axis] - margin);
      upper[axis] = static_cast<float>(local[axis] + margin);
    }
  }

  // Squared distances to the four boxes of a node, in tree coordinates, never too large by more
  // than a relative 1e-6.
  void squared_distances(const TreeNode& node, float (&distances)[TreeNode::width]) const {
    for (int c = 0; c < TreeNode::width; ++c) {
      float sum = 0.0F;
      for (int axis = 0; axis < 3; ++axis) {
        const float below = node.lower[axis][c] - upper[axis];
        const float above = lower[axis] - node.upper[axis][c];
        const float gap = std::max(std::max(below, above), 0.0F);
        sum += gap * gap;
      }
      distances[c] = sum;
    }
  }
};

struct StackEntry {
  float squared_distance;
  std::uint32_t inner;  // the node, or 0 for a leaf
  std::uint32_t first;
  std::uint32_t count;
};

}  // namespace

ClosestPoint find_closest_point(const TriangleTree& tree, const Eigen::Vector3d& point,
                                double bound) {
  constexpr double rounding = 1.0 + 4e-6;
  const BoxQuery query(tree, point);
  const double to_tree_units = tree.inverse_extent() * tree.inverse_extent() * rounding;

  ClosestPoint best{point, std::numeric_limits<double>::infinity(), 0};
  auto reach = static_cast<float>(bound * bound * to_tree_units);
  std::array<StackEntry, TriangleTree::max_stack_size> stack;
  int size = 0;
  const auto push_children = [&](const TreeNode& node) {
    float distances[TreeNode::width];
    query.squared_distances(node, distances);
    const int begin = size;
    for (int c = 0; c < TreeNode::width; ++c) {
      if (distances[c] > reach || node.count[c] == 0) continue;
      int at = size++;
      for (; at > begin && stack[at - 1].squared_distance < distances[c]; --at) {
        stack[at] = stack[at - 1];
      }
      stack[at] = {distances[c], node.inner[c], node.first[c], node.count[c]};
    }
  };
  push_children(tree.nodes()[0]);
  while (size > 0) {
    const StackEntry entry = stack[--size];
    if (entry.squared_distance > reach) continue;
    if (entry.inner != 0) {
      push_children(tree.nodes()[entry.inner]);
      continue;
    }
    for (std::uint32_t i = entry.first; i < entry.first + entry.count; ++i) {
      const Eigen::Vector3d candidate = closest_point(tree.triangles()[i], point);
      const double squared = (candidate - point).squaredNorm();
      if (squared < best.squared_distance) best = {candidate, squared, i};
    }
    reach = std::min(reach, static_cast<float>(best.squared_distance * to_tree_units));
  }
  return best;
}

}  // namespace mdbd
