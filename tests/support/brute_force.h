#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>

#include <Eigen/Geometry>

#include "features/core/ball.h"
#include "features/shape_io/triangle_mesh.h"

/// Slow and simple answers that share no code with the product.
namespace mdbd::test {

/// The distance of a point from a segment.
inline double segment_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                               const Eigen::Vector3d& x) {
  const Eigen::Vector3d ab = b - a;
  const double length = ab.squaredNorm();
  const double t = length > 0 ? std::clamp(ab.dot(x - a) / length, 0.0, 1.0) : 0.0;
  return (x - a - t * ab).norm();
}

/// The distance of a point from a triangle: by the plane where the foot is inside, else by edges.
inline double triangle_distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                const Eigen::Vector3d& c, const Eigen::Vector3d& x) {
  double distance =
      std::min({segment_distance(a, b, x), segment_distance(b, c, x), segment_distance(c, a, x)});
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double area = normal.norm();
  if (!(area > 0)) return distance;
  const bool is_inside = normal.dot((b - a).cross(x - a)) >= 0 &&
                         normal.dot((c - b).cross(x - b)) >= 0 &&
                         normal.dot((a - c).cross(x - c)) >= 0;
  return is_inside ? std::min(distance, std::abs(normal.dot(x - a)) / area) : distance;
}

/// The distance of a point from all triangles of a mesh.
inline double mesh_distance(const TriangleMesh& mesh, const Eigen::Vector3d& x) {
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    distance = std::min(distance,
                        triangle_distance(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], x));
  }
  return distance;
}

/// The winding number of a mesh around a point: every solid angle added up.
inline double mesh_winding(const TriangleMesh& mesh, const Eigen::Vector3d& x) {
  double sum = 0.0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[i] - x;
    const Eigen::Vector3d b = mesh.vertices[j] - x;
    const Eigen::Vector3d c = mesh.vertices[k] - x;
    const double above = a.dot(b.cross(c));
    const double below = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                         b.dot(c) * a.norm() + c.dot(a) * b.norm();
    sum += std::atan2(above, below);
  }
  return sum / (2.0 * std::numbers::pi);
}

/// min over balls of |x - c| - r; infinity without balls.
inline double ball_distance(std::span<const Ball> balls, const Eigen::Vector3d& x) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls) {
    distance = std::min(distance, (x - ball.center).norm() - ball.radius);
  }
  return distance;
}

/// A point with coordinates uniform in [-size, size].
inline Eigen::Vector3d random_point(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

/// A rotation, uniform over all.
inline Eigen::Quaterniond random_rotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized();
}

}  // namespace mdbd::test
