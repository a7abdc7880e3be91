#pragma once

#include <span>

#include "features/planar/planar_domain.h"

namespace mdbd {

/// How far the polygon of a curve may be from it, relative to the curve's size.
inline constexpr double flattening_tolerance = 1e-5;

/// Adds points of a Bézier curve after its first control point, which the outline ends with, up to
/// and with the last one, evenly by the parameter.
/// @pre 3 or 4 control points
void add_bezier(std::span<const Eigen::Vector2d> control, Outline& outline);

/// An arc of an ellipse as SVG gives it (SVG 1.1, F.6).
struct EllipticalArc {
  Eigen::Vector2d radii;
  double rotation = 0.0;  ///< of the first radius against the x axis, radians
  bool is_large = false;  ///< the arc is longer than half of the ellipse
  bool is_sweep = false;  ///< along it the angle grows
  Eigen::Vector2d end;
};

/// Adds points of an arc from where the outline ends to the arc's end. Radii that are too small are
/// made larger; with a radius of zero it is a straight line.
/// @pre the outline is not empty
void add_arc(const EllipticalArc& arc, Outline& outline);

}  // namespace mdbd
