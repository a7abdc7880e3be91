#pragma once

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A surface with a thickness: the closed mesh of two copies of it, moved to both sides along its
/// normals, with walls along its open edges. Outward, whatever the orientation of the surface.
///
/// Each flat part moves along its normal by exactly `half_thickness`, and creases keep that on both
/// sides, as far as three planes at a vertex allow; where the surface bends more, it is a least-
/// squares fit, and no vertex moves by more than twice as much. Faces that occur repeatedly, in
/// either orientation, count once. Where more than two faces meet at an edge, those that bend the
/// least go on and the others end there. Where the surface bends by less than half the thickness,
/// the copy on the inside crosses itself.
/// @param half_thickness object units, above 0
/// @pre no triangle has the same corner twice
TriangleMesh thicken_sheet(const TriangleMesh& mesh, double half_thickness);

}  // namespace mdbd
