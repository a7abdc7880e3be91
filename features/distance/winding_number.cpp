#include "features/distance/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

// A group counts as a dipole beyond this many times its radius (beta in Barill et al.).
constexpr double accuracy = 2.5;

struct Dipole {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d area_vector = Eigen::Vector3d::Zero();
  double squared_radius = 0.0;
};

Dipole make_dipole(std::span<const TriangleCorners> triangles) {
  Dipole dipole;
  double area = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector3d vector = 0.5 * (b - a).cross(c - a);
    const double size = vector.norm();
    area += size;
    dipole.area_vector += vector;
    dipole.center += size / 3.0 * (a + b + c);
  }
  if (area > 0) dipole.center /= area;
  for (const TriangleCorners& corners : triangles) {
    for (const Eigen::Vector3d& corner : corners) {
      dipole.squared_radius =
          std::max(dipole.squared_radius, (corner - dipole.center).squaredNorm());
    }
  }
  return dipole;
}

// atan2 to 2e-4: far better than the dipoles, and several times as fast.
inline float approximate_atan2(float y, float x) {
  const float width = std::abs(x);
  const float height = std::abs(y);
  const float larger = std::max(std::max(width, height), std::numeric_limits<float>::min());
  const float t = std::min(width, height) / larger;
  const float s = t * t;
  float angle = ((-0.0464964749F * s + 0.15931422F) * s - 0.327622764F) * s * t + t;
  angle = height > width ? 0.5F * std::numbers::pi_v<float> - angle : angle;
  angle = x < 0.0F ? std::numbers::pi_v<float> - angle : angle;
  return y < 0.0F ? -angle : angle;
}

// What the dipoles of a node's children add to the winding number, and their squared distances.
inline void dipole_terms(const float (&center)[3][TreeNode::width],
                         const float (&normal)[3][TreeNode::width], const float (&p)[3],
                         Lanes& terms, Lanes& squared) {
  MDBD_LANES
  for (int c = 0; c < TreeNode::width; ++c) {
    const float x = center[0][c] - p[0];
    const float y = center[1][c] - p[1];
    const float z = center[2][c] - p[2];
    squared[c] = x * x + y * y + z * z;
    const float flux = x * normal[0][c] + y * normal[1][c] + z * normal[2][c];
    terms[c] = flux / (squared[c] * std::sqrt(squared[c]));
  }
}

// The signed solid angles of the triangles of a block, divided by 4 pi (van Oosterom and Strackee
// 1983), in the frames of the triangles, where the sign is that of the height.
inline void solid_angles(const TriangleBlock& block, const float (&p)[3], Lanes& winding) {
  for (int i = 0; i < TriangleBlock::width; ++i) {
    // The corners seen from the point: (ax, ay), (bx, ay), (cx, cy), all at the same height.
    const auto [ax, ay, height] = block.in_frame(
        i, block.corner[0][i] - p[0], block.corner[1][i] - p[1], block.corner[2][i] - p[2]);
    const float bx = ax + block.length[i];
    const float cx = ax + block.apex[0][i];
    const float cy = ay + block.apex[1][i];
    const float level = height * height;
    const float la = std::sqrt(ax * ax + ay * ay + level);
    const float lb = std::sqrt(bx * bx + ay * ay + level);
    const float lc = std::sqrt(cx * cx + cy * cy + level);
    const float ab = ax * bx + ay * ay + level;
    const float bc = bx * cx + ay * cy + level;
    const float ca = cx * ax + cy * ay + level;
    const float denominator = la * lb * lc + ab * lc + bc * la + ca * lb;
    winding[i] = approximate_atan2(height * block.length[i] * block.apex[1][i], denominator) *
                 (0.5F / std::numbers::pi_v<float>);
  }
}

}  // namespace

WindingNumber::WindingNumber(const TriangleTree& tree) : tree_(tree) {
  dipoles_.reserve(tree.nodes().size());
  for (const TreeNode& node : tree.nodes()) dipoles_.push_back(summarise(node));
}

WindingNumber::Dipoles WindingNumber::summarise(const TreeNode& node) const {
  Dipoles dipoles{};
  std::vector<TriangleCorners> triangles;
  for (int child = 0; child < TreeNode::width; ++child) {
    if (node.count[child] == 0) continue;
    triangles.clear();
    for (std::uint32_t i = 0; i < node.count[child]; ++i) {
      const auto& [a, b, c] = tree_.triangles()[node.first[child] + i];
      triangles.push_back({to_tree_coordinates(a), to_tree_coordinates(b), to_tree_coordinates(c)});
    }
    const Dipole dipole = make_dipole(triangles);
    dipoles.reach[child] = static_cast<float>(accuracy * accuracy * dipole.squared_radius);
    for (int axis = 0; axis < 3; ++axis) {
      dipoles.center[axis][child] = static_cast<float>(dipole.center[axis]);
      dipoles.normal[axis][child] =
          static_cast<float>(dipole.area_vector[axis] / (4.0 * std::numbers::pi));
    }
  }
  return dipoles;
}

MDBD_VECTORISED
double WindingNumber::operator()(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d local = to_tree_coordinates(point);
  const float p[3] = {static_cast<float>(local.x()), static_cast<float>(local.y()),
                      static_cast<float>(local.z())};
  const TriangleBlock* const blocks = tree_.blocks().data();
  double winding = 0.0;
  std::array<std::uint32_t, TriangleTree::max_stack_size> stack;
  stack[0] = 0;
  int size = 1;
  while (size > 0) {
    const std::uint32_t index = stack[--size];
    const TreeNode& node = tree_.nodes()[index];
    const Dipoles& dipoles = dipoles_[index];
    alignas(32) Lanes terms;
    alignas(32) Lanes squared_distances;
    dipole_terms(dipoles.center, dipoles.normal, p, terms, squared_distances);
    for (int c = 0; c < TreeNode::width; ++c) {
      if (node.count[c] == 0) continue;
      if (squared_distances[c] > dipoles.reach[c]) {
        winding += static_cast<double>(terms[c]);
      } else if (node.inner[c] != 0) {
        stack[size++] = node.inner[c];
      } else {
        alignas(32) Lanes angles;
        solid_angles(blocks[node.block[c]], p, angles);
        for (std::uint32_t i = 0; i < node.count[c]; ++i) winding += static_cast<double>(angles[i]);
      }
    }
  }
  return winding;
}

Eigen::Vector3d WindingNumber::to_tree_coordinates(const Eigen::Vector3d& point) const {
  return (point - tree_.origin()) * tree_.inverse_extent();
}

}  // namespace mdbd
