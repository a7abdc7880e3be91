#include "features/implicit/csg_distance_field.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "features/core/errors.h"
#include "features/distance/enclosing_ball.h"

namespace mdbd {
namespace {

using Eigen::Vector3d;

constexpr double relative_tolerance = 1e-11;  // of the size of the solid's box
constexpr int most_rounds = 300;              // of the search for the enclosing ball

const CsgSolid& require_bounded(const CsgSolid& solid) {
  const Eigen::AlignedBox3d& box = solid.bounds();
  if (box.isEmpty()) throw InvalidInput("the solid is empty: its parts have nothing in common");
  if (!box.sizes().allFinite()) {
    throw InvalidInput(
        "the solid is not known to be bounded: intersect half spaces and complements with a box or "
        "a sphere");
  }
  return solid;
}

// Rounding grows with the distance from the origin.
double tolerance_for(const Eigen::AlignedBox3d& box) {
  const double away = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return relative_tolerance * box.sizes().maxCoeff() + 1e-14 * away;
}

}  // namespace

CsgDistanceField::CsgDistanceField(CsgSolid solid)
    : solid_(std::move(solid)),
      tolerance_(tolerance_for(require_bounded(solid_).bounds())),
      creases_(solid_, tolerance_),
      enclosing_ball_(find_enclosing_ball()) {}

/// Boundary points on smooth surfaces that are locally farthest from x and farther than `bound`.
std::vector<Vector3d> CsgDistanceField::farthest(const Vector3d& x, double bound) const {
  std::vector<Vector3d> points;
  for (const Surface& surface : solid_.surfaces()) {
    if (surface.kind != Surface::Kind::sphere && surface.kind != Surface::Kind::torus) continue;
    const Vector3d point = surface.farthest(x);
    if ((point - x).norm() > bound && solid_.is_boundary(point, tolerance_)) {
      points.push_back(point);
    }
  }
  return points;
}

// Points that stick out are added until none is left.
Ball CsgDistanceField::find_enclosing_ball() const {
  const Eigen::AlignedBox3d& box = solid_.bounds();
  std::vector<Vector3d> points = creases_.samples();
  for (int i = 0; i < 6; ++i) {
    Vector3d from = box.center();
    from[i / 2] += (i % 2 == 0 ? 1.0 : -1.0) * box.sizes().norm();
    const std::vector<Vector3d> found = farthest(from, 0.0);
    points.insert(points.end(), found.begin(), found.end());
  }
  if (points.empty()) throw InvalidInput("the solid is empty");
  Ball ball = mdbd::enclosing_ball(points);
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<Vector3d> beyond = farthest(ball.center, ball.radius + tolerance_);
    const auto on_creases = creases_.farthest(ball.center, ball.radius + tolerance_);
    beyond.insert(beyond.end(), on_creases.begin(), on_creases.end());
    if (beyond.empty()) break;
    points.insert(points.end(), beyond.begin(), beyond.end());
    ball = mdbd::enclosing_ball(points);
    std::erase_if(points, [&](const Vector3d& point) {
      return (point - ball.center).norm() < 0.9 * ball.radius;
    });
  }
  if (!(ball.radius > 0)) throw InvalidInput("the solid has no extent");
  return ball;
}

void CsgDistanceField::measure(std::span<const DistanceQuery> queries,
                               std::span<DistanceSample> samples) const {
  std::vector<double> distances;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    samples[i] = measure_point(queries[i].point, distances);
  }
}

// A plane is boundary as far as the next crease.
FlatRegion CsgDistanceField::flat_region(std::size_t surface, const Vector3d& foot) const {
  const Surface& plane = solid_.surfaces()[surface];
  if (plane.kind != Surface::Kind::plane) return {};
  const auto crease = creases_.closest(foot, std::numeric_limits<double>::infinity());
  if (!crease) return {};
  return {.number = static_cast<std::uint32_t>(surface),
          .radius = (*crease - foot).norm(),
          .normal = plane.axis};
}

DistanceSample CsgDistanceField::measure_point(const Vector3d& x,
                                               std::vector<double>& distances) const {
  solid_.measure_surfaces(x, distances);
  const double least = std::abs(solid_.value(distances));
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    // No boundary point is nearer than that.
    if (std::abs(distances[i]) >= least - tolerance_) order.emplace_back(std::abs(distances[i]), i);
  }
  const bool is_inside = solid_.contains(distances, tolerance_);
  std::ranges::make_heap(order, std::greater<>());
  double distance = std::numeric_limits<double>::infinity();
  std::optional<Vector3d> closest;
  FlatRegion region;
  for (; !order.empty() && order.front().first < distance; order.pop_back()) {
    std::ranges::pop_heap(order, std::greater<>());
    const auto [away, surface] = order.back();
    const Vector3d foot = solid_.surfaces()[surface].foot(x);
    if (solid_.is_boundary(foot, tolerance_)) {
      distance = away;
      closest = foot;
      region = flat_region(surface, foot);
    } else if (!closest) {
      closest = creases_.closest(x, distance);
      if (closest) distance = (*closest - x).norm();
    }
  }
  // What is not found may be as near as the value allows.
  if (!closest) distance = least;
  return {.distance = is_inside ? distance : -distance,
          .closest = closest.value_or(x),
          .piece = {},
          .flat_region = region};
}

}  // namespace mdbd
