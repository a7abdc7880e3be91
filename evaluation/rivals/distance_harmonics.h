#pragma once

#include <cstddef>
#include <vector>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Spheres around the centroid, and the highest degree of the harmonics on each.
inline constexpr int distance_shells = 32;
inline constexpr int distance_degree = 16;
inline constexpr std::size_t distance_harmonics_size =
    std::size_t{distance_shells} * (distance_degree + 1);

/// Spherical harmonics of the distance transform (Kazhdan, Funkhouser, Rusinkiewicz, Rotation
/// Invariant Spherical Harmonic Representation of 3D Shape Descriptors, SGP 2003): the Gaussian of
/// the distance to the surface, on 32 spheres around the surface's centroid out to twice its root
/// mean square distance from there, and of that function on each sphere the amplitude of each
/// degree, weighted by the radius of the sphere, as in the norm of the
/// function in space. Distances are exact where the paper takes those of a
/// grid of 64^3 cells. Nothing in it is random.
/// @throws InvalidInput if the mesh has no area or overflows
std::vector<float> compute_distance_harmonics(const TriangleMesh& mesh);

}  // namespace mdbd
