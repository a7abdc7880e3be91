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

/// Distances of points from a polygon: to its plane above it, else to its edges.
CornerValues distances_to_polygon(const CornerPoints& points, ConvexPolygon polygon,
                                  const Eigen::Vector3d& normal) {
  CornerValues to_edges = CornerValues::Constant(std::numeric_limits<double>::infinity());
  CornerValues inside = to_edges;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d side = edge(polygon, i);
    to_edges = to_edges.min(squared_distance_to_edge(points, polygon[i], side));
    inside = inside.min((points - polygon[i]).dot(normal.cross(side)));
  }
  const CornerValues to_plane = (points - polygon[0]).dot(normal).square() / normal.squaredNorm();
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

/// If the centre of the cube lies above the polygon: exact where all of the cube does.
std::optional<CubeBound> bound_above_polygon(ConvexPolygon polygon, const Eigen::Vector3d& x,
                                             double half_size) {
  const Eigen::Vector3d normal = area_normal(polygon);
  bool is_cube_above = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d inward = normal.cross(edge(polygon, i));
    const double margin = (x - polygon[i]).dot(inward);
    if (!(margin > 0)) return std::nullopt;
    is_cube_above = is_cube_above && margin > reach_along(inward, half_size);
  }
  const double height = (x - polygon[0]).dot(normal);
  const double scale = std::copysign(1.0 / normal.norm(), height);
  const AffineFunction plane{scale * height, scale * normal};
  const double change = reach_along(plane.slope, half_size);
  if (is_cube_above && plane.offset > change) return CubeBound{plane.offset + change, plane};
  const CornerPoints corners = corners_of_cube(x, half_size);
  return bound_by_corners(distances_to_polygon(corners, polygon, normal), corners - x, plane);
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

Eigen::Vector3d Witness::closest(const Eigen::Vector3d& x) const {
  if (piece.empty()) return center;
  const Eigen::Vector3d normal = area_normal(piece);
  bool is_above = true;
  Eigen::Vector3d best = center;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Eigen::Vector3d side = edge(piece, i);
    const Eigen::Vector3d from_corner = x - piece[i];
    is_above = is_above && normal.cross(side).dot(from_corner) > 0;
    const double t = std::clamp(side.dot(from_corner) / side.squaredNorm(), 0.0, 1.0);
    const Eigen::Vector3d candidate = piece[i] + t * side;
    const double squared = (x - candidate).squaredNorm();
    if (squared >= nearest) continue;
    best = candidate;
    nearest = squared;
  }
  if (!is_above) return best;
  return x - (x - piece[0]).dot(normal) / normal.squaredNorm() * normal;
}

CubeBound Witness::bound_over_cube(const Eigen::Vector3d& x, double half_size) const {
  if (!piece.empty()) {
    if (const auto bound = bound_above_polygon(piece, x, half_size)) return *bound;
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
