#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// How many numbers GASD has, and of how many points of the surface they are made.
inline constexpr std::size_t gasd_size = 512;
inline constexpr std::size_t gasd_points = 20'000;

/// The globally aligned spatial distribution (Lima, Teichrieb, An Efficient Global Point Cloud
/// Descriptor for Object Recognition and Pose Estimation, SIBGRAPI 2016) as PCL computes it,
/// without colour: how the points are spread over a grid of 8 x 8 x 8 cells along the principal
/// axes, in per cent. It was made for views of a camera: of the axes' directions only that of the
/// smallest extent is decided, by the z axis of the file, so that rotated copies differ.
///
/// PCL's interpolation between cells is off: with it, and one bin for each cell, PCL 1.13 counts
/// into a margin that it drops all points in the inner halves of the shells around the centroid.
/// @throws InvalidInput as sample_surface
std::vector<float> compute_gasd(const TriangleMesh& mesh, std::uint64_t seed);

}  // namespace mdbd
