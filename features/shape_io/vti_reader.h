#pragma once

#include <string>

#include "features/voxel/voxel_grid.h"

namespace mdbd {

/// Reads VTK image data in XML through VTK: the scalars of the points, or their first array.
/// @throws InvalidInput if VTK cannot read it or it has no values of one component at its points
VoxelGrid read_vti(const std::string& bytes);

}  // namespace mdbd
