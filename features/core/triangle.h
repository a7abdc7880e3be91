#pragma once

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

namespace mdbd {

/// The corners of a triangle. Object units.
using TriangleCorners = std::array<Eigen::Vector3d, 3>;

inline Eigen::Vector3d closest_point_of_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                                const Eigen::Vector3d& point) {
  const Eigen::Vector3d side = b - a;
  const double squared_length = side.squaredNorm();
  if (!(squared_length > 0)) return a;
  return a + std::clamp((point - a).dot(side) / squared_length, 0.0, 1.0) * side;
}

/// The closest point of a triangle's edges.
inline Eigen::Vector3d closest_point_of_edges(const TriangleCorners& corners,
                                              const Eigen::Vector3d& point) {
  Eigen::Vector3d closest = closest_point_of_segment(corners[2], corners[0], point);
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector3d other = closest_point_of_segment(corners[i], corners[i + 1], point);
    if ((other - point).squaredNorm() < (closest - point).squaredNorm()) closest = other;
  }
  return closest;
}

/// The closest point of a triangle, by the Voronoi regions of its corners and edges (Ericson,
/// Real-Time Collision Detection, section 5.1.5).
inline Eigen::Vector3d closest_point(const TriangleCorners& corners, const Eigen::Vector3d& point) {
  const auto& [a, b, c] = corners;
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d ap = point - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Eigen::Vector3d bp = point - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 / (d1 - d3)) * ab;
  const Eigen::Vector3d cp = point - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  }
  const double sum = va + vb + vc;
  // Rounding hides which side of a sliver is near, and even its plane.
  constexpr double least_squared_sine = 1e-14;
  if (!(sum > least_squared_sine * ab.squaredNorm() * ac.squaredNorm())) {
    return closest_point_of_edges(corners, point);
  }
  const double scale = 1.0 / sum;
  return a + (vb * scale) * ab + (vc * scale) * ac;
}

}  // namespace mdbd
