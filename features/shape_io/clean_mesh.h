#pragma once

#include "features/shape_io/mesh_statistics.h"
#include "features/shape_io/polygon_mesh.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A clean mesh, and in the statistics nothing but the counts of what was done.
struct CleanedMesh {
  TriangleMesh mesh;
  MeshStatistics dropped;
};

/// Welds vertices of exactly the same place, cuts polygons into triangles, and drops faces with bad
/// indices or without area and vertices without faces. Vertices and faces keep their order.
/// @throws InvalidInput if no face remains, or as PolygonTriangulator::triangulate
CleanedMesh clean_mesh(const PolygonMesh& polygons);

}  // namespace mdbd
