#include "features/decomposition/witness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace mdbd {
namespace {

/// One number for each corner of a cube.
using CornerValues = Eigen::Array<double, 8, 1>;

struct CornerPoints {
  CornerValues x;
  CornerValues y;
  CornerValues z;

  CornerPoints operator-(const Eigen::Vector3d& p) const {
    return {x - p.x(), y - p.y(), z - p.z()};
  }
  CornerValues dot(const Eigen::Vector3d& v) const { return x * v.x() + y * v.y() + z * v.z(); }
  CornerValues squared_norm() const { return x.square() + y.square() + z.square(); }
};

CornerPoints corners_of_cube(const Eigen::Vector3d& center, double half_size) {
  CornerPoints corners;
  corners.x << -1, 1, -1, 1, -1, 1, -1, 1;
  corners.y << -1, -1, 1, 1, -1, -1, 1, 1;
  corners.z << -1, -1, -1, -1, 1, 1, 1, 1;
  return {center.x() + half_size * corners.x, center.y() + half_size * corners.y,
          center.z() + half_size * corners.z};
}

CornerValues squared_distance_to_edge(const CornerPoints& points, const Eigen::Vector3d& a,
                                      const Eigen::Vector3d& edge) {
  const CornerPoints from_a = points - a;
  const double squared_length = edge.squaredNorm();
  if (!(squared_length > 0)) return from_a.squared_norm();
  const CornerValues t = (from_a.dot(edge) / squared_length).max(0.0).min(1.0);
  return CornerPoints{from_a.x - t * edge.x(), from_a.y - t * edge.y(), from_a.z - t * edge.z()}
      .squared_norm();
}

/// Distances of points from a triangle: to its plane above it, else to its edges.
CornerValues distances_to_triangle(const CornerPoints& points, const TriangleCorners& triangle) {
  // A triangle without a reliable normal is as good as its edges.
  constexpr double least_sine = 1e-7;
  CornerValues to_edges = CornerValues::Constant(std::numeric_limits<double>::infinity());
  CornerValues inside = CornerValues::Constant(std::numeric_limits<double>::infinity());
  const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  double longest = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d edge = triangle[(i + 1) % 3] - triangle[i];
    to_edges = to_edges.min(squared_distance_to_edge(points, triangle[i], edge));
    inside = inside.min((points - triangle[i]).dot(normal.cross(edge)));
    longest = std::max(longest, edge.squaredNorm());
  }
  const double squared_normal = normal.squaredNorm();
  if (!(squared_normal > least_sine * least_sine * longest * longest)) return to_edges.sqrt();
  const CornerValues to_plane = (points - triangle[0]).dot(normal).square() / squared_normal;
  return (inside >= 0.0).select(to_plane, to_edges).sqrt();
}

/// The largest scalar product of a vector with a point of the cube around the origin.
double reach_along(const Eigen::Vector3d& direction, double half_size) {
  return half_size * direction.lpNorm<1>();
}

CubeBound bound_by_corners(const CornerValues& values, const CornerPoints& offsets,
                           const AffineFunction& at_center) {
  return {values.maxCoeff(), {(values - offsets.dot(at_center.slope)).maxCoeff(), at_center.slope}};
}

/// If the centre of the cube lies above the triangle: exact where all of the cube does.
std::optional<CubeBound> bound_above_triangle(const TriangleCorners& triangle,
                                              const Eigen::Vector3d& x, double half_size) {
  const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  bool is_cube_above = true;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d inward = normal.cross(triangle[(i + 1) % 3] - triangle[i]);
    const double margin = (x - triangle[i]).dot(inward);
    if (!(margin > 0)) return std::nullopt;
    is_cube_above = is_cube_above && margin > reach_along(inward, half_size);
  }
  const double height = (x - triangle[0]).dot(normal);
  const double scale = std::copysign(1.0 / normal.norm(), height);
  const AffineFunction plane{scale * height, scale * normal};
  const double change = reach_along(plane.slope, half_size);
  if (is_cube_above && plane.offset > change) return CubeBound{plane.offset + change, plane};
  const CornerPoints corners = corners_of_cube(x, half_size);
  return bound_by_corners(distances_to_triangle(corners, triangle), corners - x, plane);
}

/// With t the component of an offset along n, |d + s| - n.s = sqrt(d^2 + 2 d t + |s|^2) - t, whose
/// largest value over all t is d + |s|^2 / (2 d).
CubeBound bound_of_ball(const Eigen::Vector3d& difference, double distance, double radius,
                        double half_size) {
  const double farthest = (difference.cwiseAbs().array() + half_size).matrix().norm();
  return {farthest - radius,
          {distance - radius + 1.5 * half_size * half_size / distance, difference / distance}};
}

}  // namespace

CubeBound Witness::bound_over_cube(const Eigen::Vector3d& x, double half_size) const {
  if (piece != nullptr) {
    if (const auto bound = bound_above_triangle(*piece, x, half_size)) return *bound;
  }
  const Eigen::Vector3d nearest = closest(x);
  const Eigen::Vector3d difference = x - nearest;
  const double distance = difference.norm();
  if (distance > 2.0 * half_size) return bound_of_ball(difference, distance, radius, half_size);
  const CornerPoints corners = corners_of_cube(x, half_size);
  return bound_by_corners((corners - nearest).squared_norm().sqrt() - radius, corners - x,
                          Witness{nearest, radius}.linearise(x));
}

}  // namespace mdbd
