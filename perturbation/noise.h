#pragma once

#include <cstdint>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Moves every vertex by a random vector of its own, uniform in a ball: MeshLab's random vertex
/// displacement, the noise of the paper's section 5.2.
/// @param bound the length that no vector exceeds, relative to the diameter of the smallest ball
///        that encloses the mesh: 0.01 is what the paper calls 1 %
/// @pre the mesh has vertices
/// @throws InvalidInput unless 0 <= bound <= 1
TriangleMesh displace_vertices(const TriangleMesh& mesh, double bound, std::uint64_t seed);

}  // namespace mdbd
