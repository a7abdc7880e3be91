#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "features/shape_io/point_cloud.h"

namespace mdbd {

/// A point cloud as read from a file, and what reading it dropped.
struct PointCloudFile {
  std::string format;  ///< "pcd", "ply", "xyz", "txt" or "csv"; empty if there is no file
  PointCloud cloud;    ///< at least one point, no two equal
  std::uint64_t points_not_finite = 0;  ///< dropped: a coordinate is no finite number
  std::uint64_t points_duplicate = 0;   ///< dropped: exactly where another point is
};

/// The endings that only point clouds have, in lower case with the dot: ".pcd", ".xyz", ".txt",
/// ".csv". A ".ply" may be either.
std::span<const std::string_view> point_cloud_file_extensions();

/// Whether the ending of a path, in upper or lower case, is one of point_cloud_file_extensions().
bool has_point_cloud_extension(const std::filesystem::path& path);

/// Whether a file is to be read as a point cloud: by its ending, or because it is a PLY file whose
/// header has vertices and no faces or strips of them.
/// @throws IoError if a PLY file is missing or unreadable
bool is_point_cloud_file(const std::filesystem::path& path);

/// Whether a text is a table of points as far as its first lines show: after comments and at most
/// one header, lines of at least three numbers. Tells clouds from the other texts in a folder.
/// @param beginning of the file, some kilobytes
bool looks_like_points(std::string_view beginning);

/// Reads a point cloud, with normals if the file has one for every point:
/// - PCD as text, binary or compressed, through PCL;
/// - PLY, of any encoding;
/// - tables of numbers (XYZ, TXT, CSV): the columns x y z, or x y z nx ny nz, separated by blanks,
///   tabs, commas or semicolons. A first line of words names the columns, in any order; other
///   columns are ignored, as are lines that begin with # or //. Without names a fourth to sixth
///   column are normals if they are unit vectors (intensities and colours are not).
/// Points that are not finite and exact duplicates are dropped and counted. Memory stays
/// proportional to the size of the file, whatever the file claims.
/// @throws IoError if the file is missing, a directory or unreadable
/// @throws InvalidInput if the content is no usable cloud; the message gives the reason without the
///         path
PointCloudFile read_point_cloud(const std::filesystem::path& path);

/// A cloud in memory, cleaned in the same way; its format is empty. Normals are made unit vectors;
/// if any is zero or not finite, all are dropped.
/// @pre no normals, or one for each point
/// @throws InvalidInput if no point remains, a coordinate is beyond 1e30 or all points coincide
PointCloudFile clean_point_cloud(const PointCloud& cloud);

}  // namespace mdbd
