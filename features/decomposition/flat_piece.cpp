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

AffineFunction FlatPiece::linearise(const Eigen::Vector3d& x, double margin) const {
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
  if (innermost >= 0 || nearest < margin * margin)
    return {std::abs(height), std::copysign(1.0, height) * normal_};
  const double distance = std::sqrt(height * height + nearest);
  if (!(distance > 0)) return {0.0, Eigen::Vector3d::Zero()};
  return {distance, (height * normal_ + dx * first_ + dy * second_) / distance};
}

namespace {

constexpr int lanes = 4;

/// Points in the frame of a piece.
template <int capacity>
struct FramePoints {
  alignas(32) double x[capacity];
  alignas(32) double y[capacity];
  alignas(32) double squared_height[capacity];
};

}  // namespace

template <int side>
MDBD_PART_OF_CALLER inline void FlatPiece::measure_grid(const Eigen::Vector3d& lowest, double step,
                                                        double* distances) const {
  constexpr int nodes = side * side * side;
  constexpr int end = (nodes + lanes - 1) / lanes * lanes;
  const Eigen::Vector3d offset = lowest - origin_;
  FramePoints<end> points;
  for (int node = 0; node < end; ++node) {
    const int clamped = std::min(node, nodes - 1);
    const double x = offset[0] + step * (clamped % side);
    const double y = offset[1] + step * (clamped / side % side);
    const double z = offset[2] + step * (clamped / (side * side));
    points.x[node] = x * first_[0] + y * first_[1] + z * first_[2];
    points.y[node] = x * second_[0] + y * second_[1] + z * second_[2];
    const double height = x * normal_[0] + y * normal_[1] + z * normal_[2];
    points.squared_height[node] = height * height;
  }
  alignas(32) double nearest[end];
  alignas(32) double innermost[end];
  std::fill_n(nearest, end, infinity);
  std::fill_n(innermost, end, infinity);
  for (const Edge& edge : edges_) {
    for (int i = 0; i < end; ++i) {
      const double rx = points.x[i] - edge.x;
      const double ry = points.y[i] - edge.y;
      const double along = rx * edge.along_x + ry * edge.along_y;
      const double across = ry * edge.along_x - rx * edge.along_y;
      const double beyond = along - std::min(std::max(along, 0.0), edge.length);
      nearest[i] = std::min(nearest[i], beyond * beyond + across * across);
      innermost[i] = std::min(innermost[i], across);
    }
  }
  alignas(32) double measured[end];
  for (int i = 0; i < end; ++i) {
    const double lateral = innermost[i] >= 0.0 ? 0.0 : nearest[i];
    measured[i] = std::sqrt(points.squared_height[i] + lateral);
  }
  std::copy_n(measured, nodes, distances);
}

MDBD_VECTORISED
void FlatPiece::measure_corners(const Eigen::Vector3d& lowest, double size,
                                double* distances) const {
  measure_grid<2>(lowest, size, distances);
}

MDBD_VECTORISED
void FlatPiece::measure_octants(const Eigen::Vector3d& lowest, double step,
                                double* distances) const {
  measure_grid<3>(lowest, step, distances);
}

}  // namespace mdbd
