#pragma once

#include <cstdint>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// The same mesh with its vertices and its faces in a random order and every face begun at a random
/// corner; every order is as likely as the others. Orientation stays.
TriangleMesh shuffle(const TriangleMesh& mesh, std::uint64_t seed);

}  // namespace mdbd
