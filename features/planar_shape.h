#pragma once

#include <filesystem>

#include "features/planar/planar_domain.h"
#include "features/shape.h"

namespace mdbd {

/// The shape of a file that read_planar_domain() reads.
/// @throws IoError, InvalidInput as load_shape()
Shape load_planar_shape(const std::filesystem::path& path);

/// The shape of a domain that is in memory.
/// @throws InvalidInput if it has no area
Shape make_planar_shape(const PlanarDomain& domain);

}  // namespace mdbd
