#pragma once

#include <limits>
#include <vector>

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

/// Finds for each triangle that is at most `slack` farther from a point than the closest one its
/// point that is closest. In order of distance, equal ones in the order of the tree.
/// @param bound an upper bound of the distance to the closest triangle, which must be true
/// @param[out] found replaced
void find_near_triangles(const TriangleTree& tree, const Eigen::Vector3d& point, double slack,
                         double bound, std::vector<ClosestPoint>& found);

}  // namespace mdbd
