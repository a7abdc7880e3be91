#pragma once

#include <filesystem>

#include "features/core/recipe.h"
#include "features/shape.h"
#include "features/voxel/voxel_grid.h"

namespace mdbd {

/// The shape of a file that read_voxel_grid() reads.
/// @throws IoError, InvalidInput as load_shape()
Shape load_voxel_shape(const std::filesystem::path& path, const Recipe& recipe);

/// The shape of a grid that is in memory: its iso-surface, prepared like a mesh.
/// @throws InvalidInput if it is no usable shape
Shape make_voxel_shape(const VoxelGrid& grid, const Recipe& recipe);

}  // namespace mdbd
