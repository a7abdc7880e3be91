#include "features/implicit/surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace mdbd {
namespace {

using Eigen::Vector3d;

constexpr double equal = 1e-12;  // relative to the size of what is compared

Vector3d unit_or(const Vector3d& vector, const Vector3d& otherwise) {
  const double length = vector.norm();
  return length > 0 ? Vector3d(vector / length) : otherwise;
}

Vector3d radial(const Surface& surface, const Vector3d& x) {
  const Vector3d offset = x - surface.point;
  return offset - offset.dot(surface.axis) * surface.axis;
}

/// From the closest point of the core circle of a torus.
Vector3d from_core(const Surface& torus, const Vector3d& x) {
  const Vector3d outward = unit_or(radial(torus, x), torus.axis.unitOrthogonal());
  return x - torus.point - torus.radius * outward;
}

}  // namespace

double Surface::distance(const Vector3d& x) const {
  switch (kind) {
    case Kind::plane:
      return (point - x).dot(axis);
    case Kind::sphere:
      return radius - (x - point).norm();
    case Kind::cylinder:
      return radius - radial(*this, x).norm();
    case Kind::torus:
      return tube_radius - from_core(*this, x).norm();
  }
  return 0.0;
}

Vector3d Surface::gradient(const Vector3d& x) const {
  switch (kind) {
    case Kind::plane:
      return -axis;
    case Kind::sphere:
      return -unit_or(x - point, axis);
    case Kind::cylinder:
      return -unit_or(radial(*this, x), axis.unitOrthogonal());
    case Kind::torus:
      return -unit_or(from_core(*this, x), axis);
  }
  return axis;
}

double Surface::curvature() const {
  switch (kind) {
    case Kind::plane:
      return 0.0;
    case Kind::sphere:
    case Kind::cylinder:
      return 1.0 / radius;
    case Kind::torus:
      return 1.0 / std::min(tube_radius, radius - tube_radius);
  }
  return 0.0;
}

Vector3d Surface::farthest(const Vector3d& x) const {
  if (kind == Kind::sphere) return point + radius * unit_or(point - x, axis);
  const Vector3d outward = unit_or(-radial(*this, x), axis.unitOrthogonal());
  const Vector3d core = point + radius * outward;
  return core + tube_radius * unit_or(core - x, outward);
}

int Surface::compare(const Surface& other) const {
  if (kind != other.kind) return 0;
  const double size =
      radius + std::max(point.cwiseAbs().maxCoeff(), other.point.cwiseAbs().maxCoeff());
  const Vector3d apart = other.point - point;
  if (std::abs(radius - other.radius) > equal * size) return 0;
  if (std::abs(tube_radius - other.tube_radius) > equal * size) return 0;
  if (kind == Kind::sphere) return apart.norm() <= equal * size ? 1 : 0;
  if (axis.cross(other.axis).norm() > equal) return 0;
  if (kind == Kind::plane) {
    if (std::abs(apart.dot(axis)) > equal * size) return 0;
    return axis.dot(other.axis) > 0 ? 1 : -1;
  }
  const double distance = kind == Kind::torus ? apart.norm() : axis.cross(apart).norm();
  return distance <= equal * size ? 1 : 0;
}

}  // namespace mdbd
