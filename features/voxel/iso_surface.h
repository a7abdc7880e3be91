#pragma once

#include <string>

#include "features/shape_io/triangle_mesh.h"
#include "features/voxel/voxel_grid.h"

namespace mdbd {

/// The surface between inside and outside of a grid.
struct IsoSurface {
  TriangleMesh mesh;   ///< closed, outward
  std::string kind;    ///< "signed distance" or "occupancy"
  double value = 0.0;  ///< at the surface
  std::string inside;  ///< "above" or "below" that value
};

/// The surface at zero if the values are of both signs (signed distances), else in the middle of
/// their range (occupancy, densities). Between points values are interpolated linearly, by
/// flying edges (Schroeder et al., Flying Edges, 2015; VTK's).
///
/// Outside is the side on which most points of the grid's border are. A layer of outside is put
/// around the grid, so that the surface is closed: solids that reach the border are cut there.
/// Vertices are found in single precision, relative to the grid.
/// @throws InvalidInput if all values are the same
IsoSurface find_iso_surface(const VoxelGrid& grid);

}  // namespace mdbd
