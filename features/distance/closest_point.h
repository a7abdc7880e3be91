#pragma once

#include <limits>

#include "features/distance/triangle_tree.h"

namespace mdbd {

/// The point of a mesh that is closest to another point.
struct ClosestPoint {
  Eigen::Vector3d point;    ///< object units
  double squared_distance;  ///< object units squared
  std::uint32_t triangle;   ///< index into TriangleTree::triangles()
};

/// Finds a closest point of the tree's triangles, exact but for the rounding of doubles: boxes and
/// triangles are sifted in single precision, with a margin for its errors.
/// @param bound an upper bound of the distance, which must be true; infinity if nothing is known
ClosestPoint find_closest_point(const TriangleTree& tree, const Eigen::Vector3d& point,
                                double bound = std::numeric_limits<double>::infinity());

}  // namespace mdbd
