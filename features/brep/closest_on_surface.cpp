#include "features/brep/closest_on_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace mdbd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int max_newton_steps = 30;
// After a step of this length, relative to the coordinates, the next one would be its square.
constexpr double settled = 1e-9;
// Closer to an axis than this, relative to the size of the surface, a direction is only rounding.
constexpr double axis_rounding = 1e-13;

// The angle of (x, y), or `otherwise` where it has none.
double angle_of(double x, double y, double size, double otherwise) {
  return std::hypot(x, y) > axis_rounding * size ? std::atan2(y, x) : otherwise;
}

Vector3d on_circle(const Placement& at, double u) {
  return std::cos(u) * at.x + std::sin(u) * at.y;
}

FootPoint foot_on_plane(const Placement& at, const Vector3d& local) {
  return {local.head<2>(), at.origin + local.x() * at.x + local.y() * at.y};
}

FootPoint foot_on_cylinder(const Placement& at, const Vector3d& local, const Vector2d& start) {
  const double u = angle_of(local.x(), local.y(), at.radius, start.x());
  return {{u, local.z()}, at.origin + at.radius * on_circle(at, u) + local.z() * at.z};
}

// On the nappe that holds the start; on the other one radii are negative.
std::optional<FootPoint> foot_on_cone(const Placement& at, const Vector3d& local,
                                      const Vector2d& start) {
  const double sine = std::sin(at.angle);
  const double cosine = std::cos(at.angle);
  const double nappe = at.radius + start.y() * sine < 0 ? -1.0 : 1.0;
  const double size = at.radius + std::abs(local.z());
  const double u = angle_of(nappe * local.x(), nappe * local.y(), size, start.x());
  const double v =
      (nappe * std::hypot(local.x(), local.y()) - at.radius) * sine + local.z() * cosine;
  const double radius = at.radius + v * sine;
  if (nappe * radius <= 0) return std::nullopt;
  return FootPoint{{u, v}, at.origin + radius * on_circle(at, u) + v * cosine * at.z};
}

FootPoint foot_on_sphere(const Placement& at, const Vector3d& local, const Vector2d& start) {
  const double u = angle_of(local.x(), local.y(), at.radius, start.x());
  const double v = angle_of(std::hypot(local.x(), local.y()), local.z(), at.radius, start.y());
  return {{u, v}, at.origin + at.radius * (std::cos(v) * on_circle(at, u) + std::sin(v) * at.z)};
}

FootPoint foot_on_torus(const Placement& at, const Vector3d& local, const Vector2d& start) {
  const double u = angle_of(local.x(), local.y(), at.radius, start.x());
  const double v =
      angle_of(std::hypot(local.x(), local.y()) - at.radius, local.z(), at.minor_radius, start.y());
  return {{u, v},
          at.origin + (at.radius + at.minor_radius * std::cos(v)) * on_circle(at, u) +
              at.minor_radius * std::sin(v) * at.z};
}

// The second derivatives of half the squared distance, and what they would be on a plane.
struct Hessian {
  Eigen::Matrix2d plane;
  Eigen::Matrix2d full;

  Hessian(const SurfacePoint& s, const Vector3d& offset) {
    plane << s.du.dot(s.du), s.du.dot(s.dv), s.du.dot(s.dv), s.dv.dot(s.dv);
    full = plane;
    full(0, 0) += offset.dot(s.duu);
    full(0, 1) += offset.dot(s.duv);
    full(1, 0) += offset.dot(s.duv);
    full(1, 1) += offset.dot(s.dvv);
  }

  static bool is_convex(const Eigen::Matrix2d& m) {
    return m(0, 0) > 0 && m.determinant() > 1e-10 * m(0, 0) * m(1, 1);
  }
};

// The step of Newton's method; where the squared distance is not convex, that of Gauss and Newton,
// which goes downhill everywhere.
Vector2d newton_step(const SurfacePoint& s, const Vector3d& offset) {
  const Vector2d gradient(offset.dot(s.du), offset.dot(s.dv));
  const Hessian hessian(s, offset);
  for (const Eigen::Matrix2d& matrix : {hessian.full, hessian.plane}) {
    if (Hessian::is_convex(matrix)) return -matrix.inverse() * gradient;
  }
  return -gradient / std::max(hessian.plane.trace(), std::numeric_limits<double>::min());
}

bool is_isolated(const SurfacePoint& s, const Vector3d& offset) {
  constexpr double least_growth = 0.3;
  const Hessian hessian(s, offset);
  return Hessian::is_convex(hessian.plane) &&
         Hessian::is_convex(hessian.full - least_growth * hessian.plane);
}

std::optional<FootPoint> foot_by_newton(const BrepFace& face, const Vector3d& point,
                                        const Vector2d& start, const Vector2d& lower,
                                        const Vector2d& upper) {
  const auto limit = [&](Vector2d uv) {
    for (int i = 0; i < 2; ++i) {
      if (!(face.period[i] > 0)) uv[i] = std::clamp(uv[i], lower[i], upper[i]);
    }
    return uv;
  };
  Vector2d uv = limit(start);
  SurfacePoint s = face.surface->at(uv);
  Vector3d offset = s.point - point;
  for (int i = 0; i < max_newton_steps; ++i) {
    Vector2d step = newton_step(s, offset);
    Vector2d next = limit(uv + step);
    SurfacePoint at_next = face.surface->at(next);
    // Rounding may hide the last of the gain.
    for (int halvings = 0; halvings < 20; ++halvings) {
      if ((at_next.point - point).squaredNorm() <= offset.squaredNorm() * (1 + 1e-15)) break;
      step *= 0.5;
      next = limit(uv + step);
      at_next = face.surface->at(next);
    }
    const double moved = (at_next.point - s.point).norm();
    uv = next;
    s = at_next;
    offset = s.point - point;
    if (moved <= settled * (offset.norm() + s.point.norm())) break;
  }
  return FootPoint{uv, s.point, is_isolated(s, offset)};
}

}  // namespace

std::optional<FootPoint> find_foot(const BrepFace& face, const Vector3d& point,
                                   const Vector2d& start, const Vector2d& lower,
                                   const Vector2d& upper) {
  const Placement& at = face.placement;
  switch (face.kind) {
    case SurfaceKind::plane:
      return foot_on_plane(at, at.to_local(point));
    case SurfaceKind::cylinder:
      return foot_on_cylinder(at, at.to_local(point), start);
    case SurfaceKind::cone:
      return foot_on_cone(at, at.to_local(point), start);
    case SurfaceKind::sphere:
      return foot_on_sphere(at, at.to_local(point), start);
    case SurfaceKind::torus:
      return foot_on_torus(at, at.to_local(point), start);
    case SurfaceKind::other:
      break;
  }
  return foot_by_newton(face, point, start, lower, upper);
}

}  // namespace mdbd
