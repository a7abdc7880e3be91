#pragma once

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Fewer faces: OpenMesh's decimater collapses edges, those first that cost the least by the
/// quadric error of Garland and Heckbert (Surface simplification using quadric error metrics,
/// 1997), with their planes through boundary edges, so that open meshes keep their outline. The
/// vertices that remain are some of those that were, to the bit, in the same order. A closed mesh
/// stays closed, and no face is turned over.
///
/// Where the faces at an edge or a vertex are no manifold, they are taken apart into patches that
/// are, and the vertices of the seams stay, so that nothing comes open.
///
/// The mesh that is returned has more faces than asked for if every further collapse would change
/// how the surface is connected or turn a face over: a mesh of thousands of tetrahedra stays so.
/// @param fraction of the faces that are to remain; four faces always may
/// @throws InvalidInput unless 0 < fraction <= 1
TriangleMesh decimate(const TriangleMesh& mesh, double fraction);

}  // namespace mdbd
