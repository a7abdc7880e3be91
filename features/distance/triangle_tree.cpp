#include "features/distance/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mdbd {
namespace {

constexpr std::uint32_t max_leaf_size = TriangleBlock::width;
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
      } else {
        nodes_[node].block[child] = add_block(items, children[child]);
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
  nodes_[node].block[child] = 0;
}

// The frame of a triangle in its plane, from its longest side; rounded only at the end, so that
// needles have one, too.
std::uint32_t TriangleTree::add_block(const std::vector<Item>& items, const Range& range) {
  TriangleBlock block;
  for (int i = 0; i < TriangleBlock::width; ++i) {
    const std::uint32_t item = std::min(range.begin + i, range.end - 1);
    TriangleCorners corners = items[item].corners;
    const auto squared_side = [&](int from) {
      return (corners[(from + 1) % 3] - corners[from]).squaredNorm();
    };
    int longest = 0;
    for (int side = 1; side < 3; ++side) {
      if (squared_side(side) > squared_side(longest)) longest = side;
    }
    std::rotate(corners.begin(), corners.begin() + longest, corners.end());
    const Eigen::Vector3d corner = (corners[0] - origin_) * inverse_extent_;
    const Eigen::Vector3d side = (corners[1] - corners[0]) * inverse_extent_;
    const Eigen::Vector3d other = (corners[2] - corners[0]) * inverse_extent_;
    const Eigen::Vector3d along = side.normalized();
    const Eigen::Vector3d height = other - other.dot(along) * along;
    // Of a triangle whose corners are on a line, but for rounding, the height has no direction.
    const bool is_needle = height.norm() < 1e-8 * side.norm();
    const Eigen::Vector3d across = is_needle ? along.unitOrthogonal() : height.normalized();
    for (int axis = 0; axis < 3; ++axis) {
      block.corner[axis][i] = static_cast<float>(corner[axis]);
      block.along[axis][i] = static_cast<float>(along[axis]);
      block.across[axis][i] = static_cast<float>(across[axis]);
    }
    block.length[i] = static_cast<float>(side.norm());
    block.apex[0][i] = static_cast<float>(other.dot(along));
    block.apex[1][i] = static_cast<float>(height.norm());
  }
  blocks_.push_back(block);
  return static_cast<std::uint32_t>(blocks_.size() - 1);
}

}  // namespace mdbd
