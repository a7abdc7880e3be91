#pragma once

#include "features/shape_io/mesh_statistics.h"
#include "features/shape_io/polygon_mesh.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A clean mesh with the record of what it is and what was done to it.
struct CleanedMesh {
  TriangleMesh mesh;
  MeshStatistics statistics;
};

/// Welds vertices of exactly the same place, cuts polygons into triangles, and drops faces with bad
/// indices or without area and vertices without faces. Vertices and faces keep their order.
///
/// Edges and orientation are measured while the faces that have three corners but no area are still
/// there: they join a long side to the short ones of its neighbours, and a closed mesh must not
/// seem open because they went.
/// @throws InvalidInput if no face remains, or as PolygonTriangulator::triangulate
CleanedMesh clean_mesh(const PolygonMesh& polygons);

}  // namespace mdbd
