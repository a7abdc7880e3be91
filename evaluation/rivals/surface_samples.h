#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Points drawn uniformly from the surface of a mesh: a triangle by its area, a point in it
/// uniformly (Osada, Funkhouser, Chazelle, Dobkin, Shape Distributions, 2002, section 3.2). Moved
/// and scaled so that they lie in [-1, 1]^3 around the centre of the mesh's box: none of the rivals
/// depends on position and scale, but single precision does.
/// @throws InvalidInput if the mesh has no area or overflows
std::vector<Eigen::Vector3f> sample_surface(const TriangleMesh& mesh, std::size_t count,
                                            std::uint64_t seed);

}  // namespace mdbd
