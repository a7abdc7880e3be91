#include "features/distance/dipole_winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

// A group counts as a dipole beyond this many times its radius (beta in Barill et al.).
constexpr double accuracy = 2.5;

}  // namespace

DipoleWindingNumber::DipoleWindingNumber(const PointTree& tree,
                                         std::span<const Eigen::Vector3d> area_vectors)
    : tree_(tree), blocks_(tree.blocks().size()) {
  nodes_.reserve(tree.nodes().size());
  for (const TreeNode& node : tree.nodes()) {
    nodes_.push_back(summarise(node, area_vectors));
    for (int c = 0; c < width; ++c) {
      if (node.count[c] == 0 || node.inner[c] != 0) continue;
      blocks_[node.block[c]] = gather(node.first[c], node.count[c], area_vectors);
    }
  }
}

DipoleWindingNumber::Dipoles DipoleWindingNumber::summarise(
    const TreeNode& node, std::span<const Eigen::Vector3d> area_vectors) const {
  const double scale = tree_.inverse_extent();
  Dipoles dipoles{};
  for (int c = 0; c < width; ++c) {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double area = 0.0;
    const auto local = [&](std::uint32_t i) -> Eigen::Vector3d {
      return (tree_.points()[i] - tree_.origin()) * scale;
    };
    for (std::uint32_t i = node.first[c]; i < node.first[c] + node.count[c]; ++i) {
      const double weight = area_vectors[i].norm();
      center += weight * local(i);
      normal += area_vectors[i] * scale * scale / (4 * std::numbers::pi);
      area += weight;
    }
    if (area > 0) center /= area;
    double squared_radius = 0.0;
    for (std::uint32_t i = node.first[c]; i < node.first[c] + node.count[c]; ++i) {
      squared_radius = std::max(squared_radius, (local(i) - center).squaredNorm());
    }
    for (int axis = 0; axis < 3; ++axis) {
      dipoles.center[axis][c] = static_cast<float>(center[axis]);
      dipoles.normal[axis][c] = static_cast<float>(normal[axis]);
    }
    dipoles.reach[c] = static_cast<float>(accuracy * accuracy * squared_radius);
    dipoles.smoothing[c] = std::numeric_limits<float>::min();
  }
  return dipoles;
}

DipoleWindingNumber::Dipoles DipoleWindingNumber::gather(
    std::uint32_t first, std::uint32_t count, std::span<const Eigen::Vector3d> area_vectors) const {
  const double scale = tree_.inverse_extent();
  Dipoles dipoles{};
  for (int lane = 0; lane < width; ++lane) {
    dipoles.smoothing[lane] = 1.0F;
    if (static_cast<std::uint32_t>(lane) >= count) continue;
    const std::uint32_t i = first + static_cast<std::uint32_t>(lane);
    const Eigen::Vector3d center = (tree_.points()[i] - tree_.origin()) * scale;
    const Eigen::Vector3d area_vector = area_vectors[i] * scale * scale;
    for (int axis = 0; axis < 3; ++axis) {
      dipoles.center[axis][lane] = static_cast<float>(center[axis]);
      dipoles.normal[axis][lane] = static_cast<float>(area_vector[axis] / (4 * std::numbers::pi));
    }
    dipoles.smoothing[lane] = std::max(static_cast<float>(area_vector.norm()), 1e-24F);
  }
  return dipoles;
}

inline void DipoleWindingNumber::evaluate(const Dipoles& dipoles, const float (&p)[3],
                                          float (&terms)[width], float (&squared)[width]) {
  MDBD_LANES
  for (int c = 0; c < width; ++c) {
    const float x = dipoles.center[0][c] - p[0];
    const float y = dipoles.center[1][c] - p[1];
    const float z = dipoles.center[2][c] - p[2];
    squared[c] = x * x + y * y + z * z;
    const float smoothed = squared[c] + dipoles.smoothing[c];
    const float flux =
        x * dipoles.normal[0][c] + y * dipoles.normal[1][c] + z * dipoles.normal[2][c];
    terms[c] = flux / (smoothed * std::sqrt(smoothed));
  }
}

MDBD_VECTORISED
double DipoleWindingNumber::operator()(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d local = (point - tree_.origin()) * tree_.inverse_extent();
  const float p[3] = {static_cast<float>(local.x()), static_cast<float>(local.y()),
                      static_cast<float>(local.z())};
  alignas(32) float terms[width];
  alignas(32) float squared[width];
  std::array<std::uint32_t, PointTree::max_stack_size> stack;
  int size = 0;
  stack[size++] = 0;
  double winding = 0.0;
  while (size > 0) {
    const std::uint32_t number = stack[--size];
    const TreeNode& node = tree_.nodes()[number];
    const Dipoles& dipoles = nodes_[number];
    evaluate(dipoles, p, terms, squared);
    std::array<std::uint32_t, width> leaves;
    int leaf_count = 0;
    for (int c = 0; c < width; ++c) {
      if (node.count[c] == 0) continue;
      if (squared[c] > dipoles.reach[c]) {
        winding += terms[c];
      } else if (node.inner[c] != 0) {
        stack[size++] = node.inner[c];
      } else {
        leaves[leaf_count++] = node.block[c];
      }
    }
    for (int leaf = 0; leaf < leaf_count; ++leaf) {
      evaluate(blocks_[leaves[leaf]], p, terms, squared);
      for (int i = 0; i < width; ++i) winding += terms[i];
    }
  }
  return winding;
}

}  // namespace mdbd
