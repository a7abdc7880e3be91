#pragma once

#include <vector>

#include <Eigen/Core>

#include "features/point_cloud/cloud_surface.h"
#include "features/point_cloud/neighbourhoods.h"
#include "features/shape_io/point_cloud.h"

namespace mdbd {

/// Gives the normals of a surface their sign: outward is where a flood from outside comes nearer.
///
/// The flood keeps off each point by a multiple of the spacing there, so that it does not leak
/// between samples. Where it still comes to most points from both sides, through a hole, it is kept
/// off twice as far, until it no longer does. Points that it tells nothing about take the sign of
/// their neighbours, in the order of how much the normals agree (Hoppe et al. 1992); what is
/// connected to none that it came to is the wall of a cavity, and points into it.
/// @returns for each point the unit normal, outward
/// @throws InvalidInput if the cloud encloses nothing at any scale
std::vector<Eigen::Vector3d> orient_normals(const PointCloud& cloud, const CloudSurface& surface,
                                            const Neighbourhoods& neighbourhoods);

}  // namespace mdbd
