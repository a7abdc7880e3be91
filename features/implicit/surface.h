#pragma once

#include <Eigen/Core>

namespace mdbd {

/// A smooth surface that divides space into an inside and an outside. Object units.
struct Surface {
  enum class Kind { plane, sphere, cylinder, torus };

  Kind kind = Kind::plane;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the plane, or the centre
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< of unit length; of a plane, outward
  double radius = 0.0;  ///< of the sphere, of the endless cylinder, or of the torus's core circle
  double tube_radius = 0.0;  ///< of a torus; below `radius`

  /// The signed distance, positive inside. Exact everywhere.
  double distance(const Eigen::Vector3d& x) const;

  /// Its gradient, of unit length. Where it is not unique (the centre of a sphere, the axes of a
  /// cylinder and a torus, the core of a torus), any of the limits.
  Eigen::Vector3d gradient(const Eigen::Vector3d& x) const;

  /// The closest point of the surface.
  Eigen::Vector3d foot(const Eigen::Vector3d& x) const { return x - distance(x) * gradient(x); }

  /// The largest curvature.
  double curvature() const;

  /// The farthest point, of a sphere or a torus.
  Eigen::Vector3d farthest(const Eigen::Vector3d& x) const;

  /// Whether two surfaces are the same but for rounding: 1 if they are, -1 if inside and outside
  /// are exchanged, 0 if they differ.
  int compare(const Surface& other) const;
};

}  // namespace mdbd
