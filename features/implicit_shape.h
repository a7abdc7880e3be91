#pragma once

#include <filesystem>

#include "features/shape.h"

namespace mdbd {

/// The shape of a document that read_csg() reads.
/// @throws IoError, InvalidInput as load_shape()
Shape load_implicit_shape(const std::filesystem::path& path);

}  // namespace mdbd
