#include "features/implicit/creases.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "features/core/errors.h"

namespace mdbd {
namespace {

using Eigen::Vector3d;

constexpr std::size_t most_cells = 2'000'000;
constexpr int least_depth = 3;
constexpr int usual_depth = 8;
constexpr int largest_depth = 14;    // where surfaces are nearly tangent
constexpr std::size_t few = 4;       // surfaces that a cell may hold above the usual depth
constexpr double flat = 0.15;        // half the diagonal of a fine cell, in radii of curvature
constexpr double tangent = 1e-5;     // sine of the angle below which two surfaces do not cross
constexpr double transversal = 4.0;  // sine of the angle, in the bend of the surfaces in the cell
constexpr int most_steps = 30;       // of Newton's method
constexpr double least_bend = 1e-6;  // of half the squared distance along a crease

double box_distance(const Vector3d& x, const Vector3d& center, double half) {
  return ((x - center).cwiseAbs().array() - half).max(0.0).matrix().norm();
}

double box_reach(const Vector3d& x, const Vector3d& center, double half) {
  return ((x - center).cwiseAbs().array() + half).matrix().norm();
}

}  // namespace

double Creases::Cell::radius() const { return half * std::numbers::sqrt3 * (1.0 + 1e-9); }

Creases::Creases(const CsgSolid& solid, double tolerance) : solid_(solid), tolerance_(tolerance) {
  const Eigen::AlignedBox3d& box = solid.bounds();
  // Not the middle of anything that a person would write.
  const double half = 0.5137 * box.sizes().maxCoeff();
  const Vector3d shift = 0.01 * half * Vector3d(0.31, 0.47, 0.73);
  root_ = subdivide(box.center() + shift, half, 0);
}

std::optional<std::uint32_t> Creases::subdivide(const Vector3d& center, double half, int depth) {
  if (++cells_ > most_cells) throw InvalidInput("the solid has too many edges");
  Cell cell{.center = center, .half = half, .depth = depth, .near = {}};
  std::vector<double> distances;
  solid_.measure_surfaces(center, distances);
  if (std::abs(solid_.value(distances)) > cell.radius()) return std::nullopt;
  cell.near = solid_.deciding_surfaces(distances, cell.radius());
  if (cell.near.size() < 2) return std::nullopt;

  Node node{.center = center, .half = half};
  if (is_fine(cell)) {
    node.first_crease = static_cast<std::uint32_t>(creases_.size());
    add_creases(cell);
    node.crease_count = static_cast<std::uint32_t>(creases_.size()) - node.first_crease;
    if (node.crease_count == 0) return std::nullopt;
  } else {
    std::vector<std::uint32_t> children;
    for (int i = 0; i < 8; ++i) {
      const Vector3d side((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5,
                          (i & 4) != 0 ? 0.5 : -0.5);
      const auto child = subdivide(center + half * side, 0.5 * half, depth + 1);
      if (child) children.push_back(*child);
    }
    if (children.empty()) return std::nullopt;
    node.first_child = static_cast<std::uint32_t>(children_.size());
    node.child_count = static_cast<std::uint32_t>(children.size());
    children_.insert(children_.end(), children.begin(), children.end());
  }
  nodes_.push_back(node);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

bool Creases::is_fine(const Cell& cell) const {
  if (cell.depth < least_depth) return false;
  if (cell.depth >= largest_depth) return true;
  if (cell.near.size() > few && cell.depth < usual_depth) return false;
  const std::vector<Surface>& surfaces = solid_.surfaces();
  for (std::size_t i = 0; i < cell.near.size(); ++i) {
    const Surface& first = surfaces[cell.near[i]];
    if (first.curvature() * cell.radius() > flat) return false;
    for (std::size_t j = i + 1; j < cell.near.size(); ++j) {
      const Surface& second = surfaces[cell.near[j]];
      const double bend = (first.curvature() + second.curvature()) * cell.radius();
      const auto sine = [&](const Vector3d& x) {
        return first.gradient(x).cross(second.gradient(x)).norm();
      };
      if (sine(cell.center) >= transversal * bend) continue;
      const auto common = project(cell.center, cell.near[i], cell.near[j]);
      if (!common || (*common - cell.center).norm() > 1.5 * cell.radius()) continue;
      if (sine(*common) >= tangent) return false;
    }
  }
  return true;
}

void Creases::add_creases(const Cell& cell) {
  const std::size_t count = cell.near.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      add_curve(cell, cell.near[i], cell.near[j]);
      for (std::size_t k = j + 1; k < count; ++k) {
        add_point(cell, {cell.near[i], cell.near[j], cell.near[k]});
      }
    }
  }
}

void Creases::add_curve(const Cell& cell, std::uint32_t first, std::uint32_t second) {
  const auto point = project(cell.center, first, second);
  if (!point) return;
  const double away = (*point - cell.center).norm();
  if (away > 1.5 * cell.radius()) return;
  const Vector3d along =
      solid_.surfaces()[first].gradient(*point).cross(solid_.surfaces()[second].gradient(*point));
  if (along.norm() < tangent) return;
  // Where only two surfaces are near, the curve is boundary as a whole or not at all.
  const bool is_alone = cell.near.size() == 2 && away < cell.radius();
  const bool is_boundary = solid_.is_boundary(*point, tolerance_);
  if (is_alone && !is_boundary) return;
  creases_.push_back(
      {{first, second}, *point, along.normalized(), 1.2 * (cell.radius() + away), is_alone});
  // Nearly tangent surfaces may meet in more than one curve.
  if (cell.depth == largest_depth && is_boundary) {
    creases_.push_back({{first, second}, *point, along.normalized(), 0.0, true});
  }
}

void Creases::add_point(const Cell& cell, const std::array<std::uint32_t, 3>& surfaces) {
  Vector3d point = cell.center;
  for (int step = 0; step < most_steps; ++step) {
    Eigen::Matrix3d gradients;
    Vector3d values;
    for (int i = 0; i < 3; ++i) {
      const Surface& surface = solid_.surfaces()[surfaces[static_cast<std::size_t>(i)]];
      gradients.row(i) = surface.gradient(point);
      values[i] = surface.distance(point);
    }
    if (std::abs(gradients.determinant()) < tangent) return;
    const Vector3d move = gradients.inverse() * values;
    point -= move;
    if (box_distance(point, cell.center, cell.half) > 4.0 * cell.half) return;
    if (move.norm() < 0.01 * tolerance_) break;
  }
  if (box_distance(point, cell.center, cell.half) > tolerance_) return;
  if (!solid_.is_boundary(point, tolerance_)) return;
  creases_.push_back({{surfaces[0], surfaces[1]}, point, Vector3d::Zero(), 0.0, true});
}

/// A point of both surfaces, near the start.
std::optional<Vector3d> Creases::project(const Vector3d& start, std::uint32_t first,
                                         std::uint32_t second) const {
  const Surface& a = solid_.surfaces()[first];
  const Surface& b = solid_.surfaces()[second];
  Vector3d point = start;
  for (int step = 0; step < most_steps; ++step) {
    const double at_a = a.distance(point);
    const double at_b = b.distance(point);
    if (std::max(std::abs(at_a), std::abs(at_b)) < 0.01 * tolerance_) return point;
    const Vector3d u = a.gradient(point);
    const Vector3d v = b.gradient(point);
    const double cosine = u.dot(v);
    const double determinant = u.cross(v).squaredNorm();
    if (determinant < tangent * tangent) {
      // Parallel surfaces: the foot on one, which is on the other only if they touch.
      point -= 0.5 * (at_a + std::copysign(at_b, at_b * cosine)) * u;
      if (step > 2 && std::abs(b.distance(point)) > 100 * tolerance_) return std::nullopt;
      continue;
    }
    point -= ((at_a - cosine * at_b) * u + (at_b - cosine * at_a) * v) / determinant;
    if (!point.allFinite()) return std::nullopt;
  }
  return std::nullopt;
}

/// The point of a crease that is closest (direction 1) or farthest (-1), found along the tangent:
/// where the derivative of half the squared distance is zero.
std::optional<Vector3d> Creases::extreme_point(const Crease& crease, const Vector3d& x,
                                               double direction) const {
  if (!(crease.reach > 0)) return crease.point;
  const Surface& a = solid_.surfaces()[crease.surfaces[0]];
  const Surface& b = solid_.surfaces()[crease.surfaces[1]];
  const auto clamp = [&](double s) { return std::clamp(s, -crease.reach, crease.reach); };
  double at = clamp(crease.tangent.dot(x - crease.point));
  if (direction < 0) at = clamp(-std::copysign(crease.reach, at));
  double last = at;
  double last_slope = 0.0;
  std::optional<Vector3d> point;
  for (int step = 0; step < most_steps; ++step) {
    point = project(crease.point + at * crease.tangent, crease.surfaces[0], crease.surfaces[1]);
    if (!point) return std::nullopt;
    const Vector3d along = a.gradient(*point).cross(b.gradient(*point)).normalized();
    const double slope = direction * (*point - x).dot(along);
    const double bend = step == 0 ? 1.0 : (slope - last_slope) / (at - last);
    // Where the slope falls, there is no extreme point between here and the end of the piece.
    const double next =
        clamp(bend > least_bend ? at - slope / bend : -std::copysign(crease.reach, slope));
    if (std::abs(next - at) * std::max(std::abs(slope), 1e-3 * crease.reach) <
        1e-3 * tolerance_ * crease.reach) {
      break;
    }
    last = at;
    last_slope = slope;
    at = next;
  }
  return point;
}

/// The extreme point, if it is boundary and in the cell; beyond, it is that of another cell.
std::optional<Vector3d> Creases::boundary_point(const Node& node, const Crease& crease,
                                                const Vector3d& x, double direction) const {
  const auto point = extreme_point(crease, x, direction);
  if (!point || box_distance(*point, node.center, node.half) > tolerance_) return std::nullopt;
  if (!crease.is_boundary && !solid_.is_boundary(*point, tolerance_)) return std::nullopt;
  return point;
}

std::optional<Vector3d> Creases::closest(const Vector3d& x, double bound) const {
  std::optional<Vector3d> best;
  if (!root_) return best;
  std::vector<std::pair<double, std::uint32_t>> open = {{0.0, *root_}};
  while (!open.empty()) {
    const auto [distance, index] = open.back();
    open.pop_back();
    if (distance > bound) continue;
    const Node& node = nodes_[index];
    for (std::uint32_t i = 0; i < node.crease_count; ++i) {
      const auto point = boundary_point(node, creases_[node.first_crease + i], x, 1.0);
      if (!point || (*point - x).norm() >= bound) continue;
      best = point;
      bound = (*point - x).norm();
    }
    const std::size_t first = open.size();
    for (std::uint32_t i = 0; i < node.child_count; ++i) {
      const std::uint32_t child = children_[node.first_child + i];
      const double away = box_distance(x, nodes_[child].center, nodes_[child].half);
      if (away - tolerance_ < bound) open.emplace_back(away - tolerance_, child);
    }
    std::sort(open.begin() + static_cast<std::ptrdiff_t>(first), open.end(), std::greater<>());
  }
  return best;
}

std::vector<Vector3d> Creases::farthest(const Vector3d& x, double bound) const {
  std::vector<Vector3d> points;
  for (const Node& node : nodes_) {
    if (node.crease_count == 0 || box_reach(x, node.center, node.half) < bound) continue;
    for (std::uint32_t i = 0; i < node.crease_count; ++i) {
      const auto point = boundary_point(node, creases_[node.first_crease + i], x, -1.0);
      if (point && (*point - x).norm() > bound) points.push_back(*point);
    }
  }
  return points;
}

std::vector<Vector3d> Creases::samples() const {
  std::vector<Vector3d> points;
  for (const Crease& crease : creases_) {
    if (crease.is_boundary || solid_.is_boundary(crease.point, tolerance_)) {
      points.push_back(crease.point);
    }
  }
  return points;
}

}  // namespace mdbd
