#pragma once

#include "features/shape_io/plain_file.h"
#include "features/shape_io/polygon_mesh.h"

namespace mdbd {

/// Reads a plain file through OpenMesh and keeps every face, whatever it joins: OpenMesh's own
/// meshes would drop those at edges of three faces or more.
/// Safe to call from several threads; OpenMesh's readers are shared objects, so calls wait for each
/// other.
/// @throws InvalidInput if OpenMesh finds other counts than the plain file states
PolygonMesh read_with_openmesh(PlainFile file);

}  // namespace mdbd
