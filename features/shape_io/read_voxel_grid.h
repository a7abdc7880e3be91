#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "features/voxel/voxel_grid.h"

namespace mdbd {

/// A grid as read from a file.
struct VoxelFile {
  std::string format;  ///< "nrrd", "nhdr", "mha", "mhd", "vtk" or "vti"
  VoxelGrid grid;
};

/// The endings that read_voxel_grid understands, in lower case with the dot.
std::span<const std::string_view> voxel_file_extensions();

/// Reads a grid of one value at each point: NRRD (raw, ascii, gzip), MetaImage (raw, text, zlib),
/// legacy VTK (structured points) and VTK image data in XML. Where the data are in a file of their
/// own, it lies in the folder of the header or below. The sizes are compared with the size of the
/// file before anything is allocated.
/// @throws IoError if the file is missing, a directory or unreadable
/// @throws InvalidInput if the content is no usable grid, of two to 512^3 points
VoxelFile read_voxel_grid(const std::filesystem::path& path);

}  // namespace mdbd
