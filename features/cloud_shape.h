#pragma once

#include <filesystem>

#include "features/shape.h"
#include "features/shape_io/point_cloud.h"

namespace mdbd {

/// The shape of a file that read_point_cloud() reads.
/// @throws IoError, InvalidInput as load_shape()
Shape load_cloud_shape(const std::filesystem::path& path);

/// The shape of a point cloud that is in memory.
/// @throws InvalidInput if it is no usable shape
Shape make_cloud_shape(const PointCloud& cloud);

}  // namespace mdbd
