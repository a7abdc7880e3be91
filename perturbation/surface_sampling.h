#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "features/shape_io/point_cloud.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Points drawn uniformly from the surface of a mesh: a triangle by its area, a point in it
/// uniformly (Osada, Funkhouser, Chazelle, Dobkin, Shape Distributions, 2002, section 3.2). Without
/// normals. Object units; the same seed gives the same points.
/// @throws InvalidInput if the mesh has no area or it overflows
PointCloud sample_points(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed);

/// Moves every point by a random vector of its own, as displace_vertices() does with a mesh.
/// @param bound the length that no vector exceeds, relative to the diameter of the smallest ball
///        that encloses the cloud
/// @pre the cloud has points
/// @throws InvalidInput unless 0 <= bound <= 1
PointCloud displace_points(const PointCloud& cloud, double bound, std::uint64_t seed);

/// Rotates points and normals about the middle of the cloud by a random rotation, uniform among
/// all: what rotate() does with a mesh.
/// @pre the cloud has points
PointCloud rotate(const PointCloud& cloud, std::uint64_t seed);

/// How a cloud is drawn from a mesh.
struct CloudSampling {
  std::size_t points = 20'000;
  double noise = 0.0;  ///< percent of the enclosing ball's diameter, see displace_points()
};

/// Reads a mesh, draws a cloud from it, moves its points and rotates it. The seed of the copy is
/// derived as by perturb_file().
/// @throws IoError, InvalidInput as read_mesh(), sample_points() and displace_points()
PointCloud sample_file(const std::filesystem::path& path, const CloudSampling& sampling,
                       std::uint64_t seed);

}  // namespace mdbd
