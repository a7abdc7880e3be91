#pragma once

#include <cstdint>

#include "features/shape_io/triangle_mesh.h"

/// Moves under which a shape stays the same shape. What is random is uniform. "The middle" is the
/// centre of the smallest ball that encloses the mesh.
/// @pre for all: the mesh has vertices
namespace mdbd {

/// Rotates about the middle by a random rotation.
TriangleMesh rotate(const TriangleMesh& mesh, std::uint64_t seed);

/// Moves in a random direction.
/// @param distance relative to the diameter of the enclosing ball
/// @throws InvalidInput unless 0 <= distance <= 1e6
TriangleMesh translate(const TriangleMesh& mesh, double distance, std::uint64_t seed);

/// Multiplies all coordinates by a factor.
/// @throws InvalidInput unless 1e-6 <= factor <= 1e6
TriangleMesh scale(const TriangleMesh& mesh, double factor);

/// Reflects at a random plane through the middle; faces are turned, so that what was outward stays
/// outward.
TriangleMesh mirror(const TriangleMesh& mesh, std::uint64_t seed);

}  // namespace mdbd
