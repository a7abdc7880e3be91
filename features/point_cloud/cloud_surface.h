#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "features/point_cloud/neighbourhoods.h"
#include "features/shape_io/point_cloud.h"

namespace mdbd {

/// What the neighbours of each point tell of the surface that a cloud was taken from. One entry for
/// each point; object units.
struct CloudSurface {
  std::vector<double> areas;             ///< of the piece of the surface that the point stands for
  std::vector<Eigen::Vector3d> normals;  ///< unit vectors; the sign means nothing
  /// The side of a square with the median of the areas: how far neighbouring samples are apart.
  double spacing = 0.0;
};

/// Fits a plane to each point and its neighbours (principal component analysis; Hoppe et al.,
/// Surface reconstruction from unorganized points, 1992). The area is that of the disc which the
/// neighbours fill, divided by their number: unbiased where samples are independent and uniform.
CloudSurface estimate_surface(const PointCloud& cloud, const Neighbourhoods& neighbourhoods);

}  // namespace mdbd
