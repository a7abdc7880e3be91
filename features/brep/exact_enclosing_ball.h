#pragma once

#include <span>

#include "features/brep/brep.h"
#include "features/brep/trim.h"
#include "features/core/ball.h"

namespace mdbd {

/// The smallest ball that encloses the exact surfaces: that of the tessellation's nodes, which
/// grows by the points of surfaces and edges that are farthest from its centre, until none sticks
/// out by more than a relative 1e-13.
/// @param trims of each face
/// @param deflection the surfaces are at most so far from the tessellation; object units
/// @pre the mesh has a vertex
Ball exact_enclosing_ball(const Brep& brep, std::span<const Trim> trims, double deflection);

}  // namespace mdbd
