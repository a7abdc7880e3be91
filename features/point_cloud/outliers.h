#pragma once

#include <vector>

#include "features/point_cloud/neighbourhoods.h"
#include "features/shape_io/point_cloud.h"

namespace mdbd {

/// Finds points that lie alone: their neighbours are several times as far away as those of their
/// neighbours are, or many times as far as is usual in the cloud. Density that varies steadily, or
/// at an edge by a factor of ten, does not make outliers.
/// @returns for each point whether it is one; none where more than 5 % of the points would be,
///          since then they belong to the shape
std::vector<bool> find_outliers(const PointCloud& cloud, const Neighbourhoods& neighbourhoods);

}  // namespace mdbd
