#include "features/shape_io/flatten_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace mdbd {
namespace {

// A point of a Bézier curve (de Casteljau).
Eigen::Vector2d evaluate(std::span<const Eigen::Vector2d> control, double t) {
  std::vector<Eigen::Vector2d> points(control.begin(), control.end());
  for (std::size_t left = points.size() - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) points[i] += t * (points[i + 1] - points[i]);
  }
  return points.front();
}

// So many pieces of equal parameter length are within the tolerance (Wang's formula).
int piece_count(std::span<const Eigen::Vector2d> control) {
  double size = 0.0;
  for (const Eigen::Vector2d& point : control) size = std::max(size, (point - control[0]).norm());
  if (!(size > 0)) return 1;
  double bend = 0.0;
  for (std::size_t i = 0; i + 2 < control.size(); ++i) {
    bend = std::max(bend, (control[i] - 2.0 * control[i + 1] + control[i + 2]).norm());
  }
  const auto degree = static_cast<double>(control.size() - 1);
  const double tolerance = flattening_tolerance * size;
  return std::max(
      1, static_cast<int>(std::ceil(std::sqrt(degree * (degree - 1) * bend / (8 * tolerance)))));
}

double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

// An arc in the coordinates in which its ellipse is the unit circle.
struct CircularArc {
  Eigen::Vector2d center;
  double start_angle;
  double sweep_angle;
};

CircularArc find_circle(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double radius,
                        bool is_large, bool is_sweep) {
  const Eigen::Vector2d half = 0.5 * (end - start);
  const double height = std::sqrt(std::max(0.0, radius * radius - half.squaredNorm()));
  const Eigen::Vector2d across = Eigen::Vector2d(-half.y(), half.x()).normalized();
  const Eigen::Vector2d center =
      0.5 * (start + end) + (is_large == is_sweep ? -height : height) * across;
  const Eigen::Vector2d to_start = start - center;
  double sweep = angle_between(to_start, end - center);
  constexpr double turn = 2 * std::numbers::pi;
  if (is_sweep && sweep < 0) sweep += turn;
  if (!is_sweep && sweep > 0) sweep -= turn;
  return {center, std::atan2(to_start.y(), to_start.x()), sweep};
}

}  // namespace

void add_bezier(std::span<const Eigen::Vector2d> control, Outline& outline) {
  const int pieces = piece_count(control);
  for (int i = 1; i < pieces; ++i) outline.push_back(evaluate(control, double(i) / pieces));
  outline.push_back(control.back());
}

void add_arc(const EllipticalArc& arc, Outline& outline) {
  const Eigen::Vector2d start = outline.back();
  const Eigen::Vector2d radii = arc.radii.cwiseAbs();
  if (start == arc.end) return;
  if (!(radii.minCoeff() > 0)) {
    outline.push_back(arc.end);
    return;
  }
  const Eigen::Rotation2Dd rotation(arc.rotation);
  const auto to_circle = [&](const Eigen::Vector2d& point) {
    return Eigen::Vector2d((rotation.inverse() * point).cwiseQuotient(radii));
  };
  const Eigen::Vector2d from = to_circle(start);
  const Eigen::Vector2d to = to_circle(arc.end);
  const double radius = std::max(1.0, 0.5 * (to - from).norm());
  const CircularArc circle = find_circle(from, to, radius, arc.is_large, arc.is_sweep);
  const double step = 2 * std::acos(1.0 - 2 * flattening_tolerance);
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(circle.sweep_angle) / step)));
  for (int i = 1; i < pieces; ++i) {
    const double angle = circle.start_angle + circle.sweep_angle * i / pieces;
    const Eigen::Vector2d on_circle =
        circle.center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    outline.push_back(rotation * on_circle.cwiseProduct(radii));
  }
  outline.push_back(arc.end);
}

}  // namespace mdbd
