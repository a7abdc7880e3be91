#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Geometry>

namespace mdbd {

/// The corners of a flat convex polygon, three or more, in order; empty if there is none.
/// Successive edges may lie on one line. Object units.
using ConvexPolygon = std::span<const Eigen::Vector3d>;

/// A normal of a polygon, with twice its area as length.
inline Eigen::Vector3d area_normal(ConvexPolygon polygon) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    normal += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  }
  return normal;
}

/// The edge from one corner to the next.
inline Eigen::Vector3d edge(ConvexPolygon polygon, std::size_t corner) {
  return polygon[corner + 1 == polygon.size() ? 0 : corner + 1] - polygon[corner];
}

}  // namespace mdbd
