#include "features/decomposition/flat_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int corners = 8;

}  // namespace

FlatPiece::FlatPiece(ConvexPolygon polygon) : origin_(polygon[0]) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i) {
    if (edge(polygon, i).squaredNorm() > edge(polygon, longest).squaredNorm()) longest = i;
  }
  normal_ = area_normal(polygon).normalized();
  const Eigen::Vector3d side = edge(polygon, longest);
  first_ = (side - side.dot(normal_) * normal_).normalized();
  second_ = normal_.cross(first_);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d from = polygon[i] - origin_;
    const Eigen::Vector3d vector = edge(polygon, i);
    const Eigen::Vector2d flat(vector.dot(first_), vector.dot(second_));
    const double length = flat.norm();
    if (!(length > 0)) continue;
    edges_.push_back(
        {from.dot(first_), from.dot(second_), flat.x() / length, flat.y() / length, length});
  }
}

AffineFunction FlatPiece::linearise(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d offset = x - origin_;
  const double px = offset.dot(first_);
  const double py = offset.dot(second_);
  const double height = offset.dot(normal_);
  double innermost = infinity;
  double nearest = infinity;
  double dx = 0.0;  // from the closest point of an edge
  double dy = 0.0;
  for (const Edge& edge : edges_) {
    const double rx = px - edge.x;
    const double ry = py - edge.y;
    const double along = rx * edge.along_x + ry * edge.along_y;
    innermost = std::min(innermost, ry * edge.along_x - rx * edge.along_y);
    const double t = std::min(std::max(along, 0.0), edge.length);
    const double ex = rx - t * edge.along_x;
    const double ey = ry - t * edge.along_y;
    const double squared = ex * ex + ey * ey;
    if (squared >= nearest) continue;
    nearest = squared;
    dx = ex;
    dy = ey;
  }
  if (innermost >= 0) return {std::abs(height), std::copysign(1.0, height) * normal_};
  const double distance = std::sqrt(height * height + nearest);
  if (!(distance > 0)) return {0.0, Eigen::Vector3d::Zero()};
  return {distance, (height * normal_ + dx * first_ + dy * second_) / distance};
}

// The distance is convex, and so is its difference from a linear function: both are largest at a
// corner of the cube.
MDBD_VECTORISED
DistanceBound FlatPiece::bound_over_cube(const Eigen::Vector3d& x, double half_size,
                                         const Eigen::Vector3d& slope) const {
  const Eigen::Vector3d offset = x - origin_;
  alignas(32) double rise[corners];
  alignas(32) double px[corners];
  alignas(32) double py[corners];
  alignas(32) double squared_height[corners];
  for (int i = 0; i < corners; ++i) {
    const double ox = (i & 1) != 0 ? half_size : -half_size;
    const double oy = (i & 2) != 0 ? half_size : -half_size;
    const double oz = (i & 4) != 0 ? half_size : -half_size;
    rise[i] = ox * slope[0] + oy * slope[1] + oz * slope[2];
    const double cx = offset[0] + ox;
    const double cy = offset[1] + oy;
    const double cz = offset[2] + oz;
    px[i] = cx * first_[0] + cy * first_[1] + cz * first_[2];
    py[i] = cx * second_[0] + cy * second_[1] + cz * second_[2];
    const double height = cx * normal_[0] + cy * normal_[1] + cz * normal_[2];
    squared_height[i] = height * height;
  }
  alignas(32) double nearest[corners];
  alignas(32) double innermost[corners];
  std::fill_n(nearest, corners, infinity);
  std::fill_n(innermost, corners, infinity);
  for (const Edge& edge : edges_) {
    for (int i = 0; i < corners; ++i) {
      const double rx = px[i] - edge.x;
      const double ry = py[i] - edge.y;
      const double along = rx * edge.along_x + ry * edge.along_y;
      const double across = ry * edge.along_x - rx * edge.along_y;
      const double beyond = along - std::min(std::max(along, 0.0), edge.length);
      nearest[i] = std::min(nearest[i], beyond * beyond + across * across);
      innermost[i] = std::min(innermost[i], across);
    }
  }
  alignas(32) double distance[corners];
  for (int i = 0; i < corners; ++i) {
    const double lateral = innermost[i] >= 0.0 ? 0.0 : nearest[i];
    distance[i] = std::sqrt(squared_height[i] + lateral);
  }
  double largest = 0.0;
  double constant = -infinity;
  for (int i = 0; i < corners; ++i) {
    largest = std::max(largest, distance[i]);
    constant = std::max(constant, distance[i] - rise[i]);
  }
  return {largest, constant};
}

}  // namespace mdbd
