#pragma once

#include <string_view>

#include "features/shape_io/point_cloud.h"

/// The formats of point clouds: each function examines the bytes of a file and takes the points out
/// of it as they are, finite or not. There are normals if the file has three numbers for each
/// point's, of whatever length.
/// @throws InvalidInput with the reason if the content is damaged, truncated, absurd or without
///         points
namespace mdbd {

PointCloud read_pcd(std::string_view bytes);
PointCloud read_ply_points(std::string_view bytes);
PointCloud read_point_table(std::string_view bytes);

/// Whether a PLY file has vertices and no faces or strips of them, as its header says. False if it
/// has no header.
/// @param beginning of the file, with the header
bool has_ply_points_alone(std::string_view beginning);

}  // namespace mdbd
