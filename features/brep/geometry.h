#pragma once

#include <Eigen/Core>

/// The curves and surfaces of a boundary representation, as functions of their parameters.
namespace mdbd {

/// A surface at a pair of parameters, with its partial derivatives. Object units.
struct SurfacePoint {
  Eigen::Vector3d point;
  Eigen::Vector3d du;
  Eigen::Vector3d dv;
  Eigen::Vector3d duu;
  Eigen::Vector3d dvv;
  Eigen::Vector3d duv;
};

/// A curve at a parameter, with its derivatives. Object units.
struct CurvePoint {
  Eigen::Vector3d point;
  Eigen::Vector3d first;
  Eigen::Vector3d second;
};

/// A surface in space. Thread-safe.
class ParametricSurface {
 public:
  virtual ~ParametricSurface() = default;
  /// @throws InvalidInput if the surface is singular beyond evaluation
  virtual SurfacePoint at(const Eigen::Vector2d& uv) const = 0;
};

/// A curve in space. Thread-safe.
class ParametricCurve {
 public:
  virtual ~ParametricCurve() = default;
  /// @throws InvalidInput as ParametricSurface
  virtual CurvePoint at(double t) const = 0;
};

/// A curve in the plane of a surface's parameters. Thread-safe.
class ParameterCurve {
 public:
  virtual ~ParameterCurve() = default;
  /// @throws InvalidInput as ParametricSurface
  virtual Eigen::Vector2d at(double t) const = 0;
};

/// Surfaces whose closest point has a closed form; `other` has none.
enum class SurfaceKind { plane, cylinder, cone, sphere, torus, other };
enum class CurveKind { line, circle, other };

/// Where a surface or curve of a known kind lies: three orthogonal unit vectors, of either hand,
/// and its sizes. With c = cos u x + sin u y the surfaces are, as functions of (u, v):
///   plane     origin + u x + v y
///   cylinder  origin + radius c + v z
///   cone      origin + (radius + v sin(angle)) c + v cos(angle) z
///   sphere    origin + radius (cos v c + sin v z)
///   torus     origin + (radius + minor_radius cos v) c + minor_radius sin v z
/// and a circle is, as function of u, origin + radius c.
struct Placement {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  double radius = 0.0;
  double minor_radius = 0.0;  ///< of a torus, not above its radius
  double angle = 0.0;         ///< of a cone, between axis and surface; radians

  Eigen::Vector3d to_local(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d offset = point - origin;
    return {offset.dot(x), offset.dot(y), offset.dot(z)};
  }
};

}  // namespace mdbd
