#include "features/brep/closest_on_edge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/core/triangle.h"

namespace mdbd {
namespace {

using Eigen::Vector3d;

constexpr int max_newton_steps = 40;

Vector3d nearer_end(const BrepEdge& edge, const Vector3d& point) {
  const Vector3d first = edge.curve->at(edge.parameters.front()).point;
  const Vector3d last = edge.curve->at(edge.parameters.back()).point;
  return (first - point).squaredNorm() <= (last - point).squaredNorm() ? first : last;
}

// The distance from an arc has no other minimum than the nearest point of the circle and the ends.
Vector3d closest_on_arc(const BrepEdge& edge, const Vector3d& point) {
  const Placement& at = edge.placement;
  const Vector3d local = at.to_local(point);
  constexpr double turn = 2.0 * std::numbers::pi;
  const double first = edge.parameters.front();
  double t = std::atan2(local.y(), local.x());
  t += turn * std::ceil((first - t) / turn);
  if (t > edge.parameters.back()) return nearer_end(edge, point);
  return at.origin + at.radius * (std::cos(t) * at.x + std::sin(t) * at.y);
}

// Newton's method for half the squared distance, with bisection where it leaves what is possible.
Vector3d closest_between(const BrepEdge& edge, double lower, double upper, double start,
                         const Vector3d& point) {
  double t = start;
  CurvePoint at = edge.curve->at(t);
  for (int i = 0; i < max_newton_steps; ++i) {
    const Vector3d offset = at.point - point;
    const double slope = offset.dot(at.first);
    (slope > 0 ? upper : lower) = t;
    const double curvature = at.first.squaredNorm() + offset.dot(at.second);
    double next = curvature > 0 ? t - slope / curvature : (slope > 0 ? lower : upper);
    if (!(next > lower && next < upper)) next = 0.5 * (lower + upper);
    const CurvePoint at_next = edge.curve->at(next);
    const bool is_done =
        (at_next.point - at.point).norm() <= 1e-15 * (offset.norm() + at.point.norm());
    t = next;
    at = at_next;
    if (is_done) break;
  }
  return at.point;
}

}  // namespace

Vector3d closest_point(const BrepEdge& edge, std::size_t segment, const Vector3d& point) {
  if (edge.kind == CurveKind::circle) return closest_on_arc(edge, point);
  const std::vector<double>& t = edge.parameters;
  const Vector3d from = edge.curve->at(t[segment]).point;
  const Vector3d to = edge.curve->at(t[segment + 1]).point;
  const Vector3d on_chord = closest_point_of_segment(from, to, point);
  if (edge.kind == CurveKind::line) return on_chord;
  const double length = (to - from).norm();
  const double share = length > 0 ? (on_chord - from).norm() / length : 0.5;
  const double lower = t[segment == 0 ? 0 : segment - 1];
  const double upper = t[std::min(segment + 2, t.size() - 1)];
  const double start = t[segment] + share * (t[segment + 1] - t[segment]);
  Vector3d best = closest_between(edge, lower, upper, start, point);
  for (const Vector3d& node : {from, to}) {
    if ((node - point).squaredNorm() < (best - point).squaredNorm()) best = node;
  }
  return best;
}

}  // namespace mdbd
