#pragma once

#include <filesystem>

#include "features/shape.h"

namespace mdbd {

/// The shape of a file that read_brep() reads. Faces that make no solid, and
/// solids thinner than the least balls, go the way of meshes, as their tessellation.
/// @param path of a file, or of one solid of it (solid_path.h)
/// @throws IoError, InvalidInput as load_shape()
Shape load_brep_shape(const std::filesystem::path& path, const Recipe& recipe);

}  // namespace mdbd
