#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// How many numbers ESF has, and of how many points of the surface they are made.
inline constexpr std::size_t esf_size = 640;
inline constexpr std::size_t esf_points = 20'000;

/// The ensemble of shape functions (Wohlkinger, Vincze, Ensemble of Shape Functions for 3D Object
/// Classification, ROBIO 2011) as PCL computes it: ten histograms of distances, angles and areas of
/// random triples of points, apart by whether the lines between them run inside, outside or both.
/// They sum to 1 and do not depend on position and scale.
///
/// PCL draws the triples with rand() after seeding it with the time of day; here both are given
/// other meanings for PCL's code, so that the numbers depend on the mesh and the seed only.
/// @throws InvalidInput as sample_surface
std::vector<float> compute_esf(const TriangleMesh& mesh, std::uint64_t seed);

}  // namespace mdbd
