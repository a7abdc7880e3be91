#pragma once

#include <cstdint>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Turns single faces that are the wrong way round on a closed surface, and whole shells that are:
/// of each shell, faces connected through edges of two, the minority by area follows the majority,
/// and a closed shell that encloses a negative volume is turned unless it lies inside the others,
/// where it is a cavity.
/// @param mesh without open edges; else nothing says which side is which
/// @returns how many faces were turned
std::uint64_t orient_shells(TriangleMesh& mesh);

}  // namespace mdbd
