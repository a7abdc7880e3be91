#pragma once

#include <string_view>

#include "features/implicit/csg_solid.h"

namespace mdbd {

/// What the "format" of a JSON document says that holds a solid.
inline constexpr std::string_view csg_format = "mdbd-csg";

/// Reads a solid of constructive solid geometry from JSON; docs/solids.md describes the document.
/// @throws InvalidInput with the reason and the place, as a JSON pointer
///         ("/solid/union/1/sphere/radius: must be above 0"), if it is no such document, nested
///         deeper than 64 or of more than 2,000 primitives
CsgSolid read_csg(std::string_view bytes);

}  // namespace mdbd
