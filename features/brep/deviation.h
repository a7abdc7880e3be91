#pragma once

#include "features/brep/brep.h"

namespace mdbd {

/// How far the surface of a face is from a triangle of its tessellation, measured at one point: on
/// surfaces with a closed form at the point of the triangle, on others at the surface's point of
/// equal parameters. Object units.
/// @param weight barycentric coordinates in the triangle
/// @throws InvalidInput if the surface cannot be evaluated
double measure_deviation(const Brep& brep, std::size_t triangle, const Eigen::Vector3d& weight);

/// The point of the surface that stands for a point of a triangle.
/// @param corners, weight as above; the corners are vertices of the tessellation of the face
Eigen::Vector3d lift_to_surface(const Brep& brep, const BrepFace& face, const Triangle& corners,
                                const Eigen::Vector3d& weight);

}  // namespace mdbd
