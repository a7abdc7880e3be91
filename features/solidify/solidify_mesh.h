#pragma once

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A mesh that encloses something, with what was done to it.
struct SolidifiedMesh {
  TriangleMesh mesh;
  double enclosing_share = 1.0;  ///< how much of the surface has an inside: see measure_enclosure()
  double thickness = 0.0;        ///< that sheets were given, in object units; 0 if none was
};

/// How much of a surface must have an inside, or else it is taken for a sheet.
inline constexpr double least_enclosing_share = 0.3;

/// The thickness that sheets are given, relative to R.
inline constexpr double sheet_thickness = 0.04;

/// Gives a thickness to a surface that encloses nothing: one of which less than
/// `least_enclosing_share` has an inside. Its parts, faces connected through edges, that enclose
/// something by themselves stay as they are; the others are thickened: see thicken_sheet().
/// Otherwise the mesh is the same.
///
/// A closed surface is only looked at if its volume is small for its area, so that solids cost
/// nothing.
/// @param is_closed whether the mesh is watertight and oriented alike
/// @param minimum_radius relative to R: what encloses no ball of this radius encloses nothing
SolidifiedMesh solidify_mesh(TriangleMesh mesh, bool is_closed, double minimum_radius);

/// What solidify_mesh() finds, without doing anything about it.
double measure_enclosing_share(const TriangleMesh& mesh, bool is_closed, double minimum_radius);

}  // namespace mdbd
