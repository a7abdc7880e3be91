#pragma once

#include <span>
#include <vector>

#include "features/brep/brep.h"
#include "features/brep/trim.h"
#include "features/core/ball.h"

namespace mdbd {

/// How far surfaces and edges are from their tessellation at most. Object units.
struct Deflections {
  std::vector<double> triangles;  ///< for each triangle of the mesh
  std::vector<double> edges;      ///< for each edge
};

/// The smallest ball that encloses the exact surfaces: that of the tessellation's nodes, which
/// grows by the points of surfaces and edges that are farthest from its centre, until none sticks
/// out by more than a relative 1e-12.
/// @param trims of each face
/// @pre the mesh has a vertex
Ball exact_enclosing_ball(const Brep& brep, std::span<const Trim> trims,
                          const Deflections& deflections);

}  // namespace mdbd
