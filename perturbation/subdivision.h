#pragma once

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Cuts every triangle into four at the midpoints of its edges, which neighbours share. The surface
/// stays where it is, up to the rounding of the midpoints.
/// @throws InvalidInput if more than 50 million triangles would come of it
TriangleMesh subdivide(const TriangleMesh& mesh);

}  // namespace mdbd
