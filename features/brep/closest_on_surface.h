#pragma once

#include <optional>

#include "features/brep/brep.h"

namespace mdbd {

/// A point of a surface that is a local minimum of the distance, whether on the face or beyond.
struct FootPoint {
  Eigen::Vector2d uv;
  Eigen::Vector3d point;
  /// Newton's method found it, and the distance grows all around as it does from a plane, within a
  /// factor: whatever starts nearby comes to the same foot.
  bool is_isolated = false;
};

/// The foot of a point on the surface of a face: in closed form on planes, cylinders, cones,
/// spheres and tori, by Newton's method from `start` on others. None if the nearest point is
/// singular (the apex of a cone) or Newton's method leaves the parameters of the face, so that the
/// closest point of the face is on its edges.
/// @param start parameters of a point of the face near the foot
/// @param lower, upper the smallest box of parameters that holds the face
std::optional<FootPoint> find_foot(const BrepFace& face, const Eigen::Vector3d& point,
                                   const Eigen::Vector2d& start, const Eigen::Vector2d& lower,
                                   const Eigen::Vector2d& upper);

}  // namespace mdbd
