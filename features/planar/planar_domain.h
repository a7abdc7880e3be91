#pragma once

#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// A closed outline in the plane, whose last point is joined to the first.
using Outline = std::vector<Eigen::Vector2d>;

/// A bounded part of the plane: what is inside an odd number of its outlines.
using PlanarDomain = std::vector<Outline>;

/// The same domain by outlines that neither cross nor overlap: those around it counterclockwise,
/// those around its holes clockwise. Points where outlines cross become vertices, rounded to about
/// machine precision of the extent; vertices in the middle of a straight side are dropped.
/// @throws InvalidInput if a coordinate is not finite, or the domain has no area
PlanarDomain simplify(const PlanarDomain& domain);

/// The area of a domain of simple outlines, as simplify() makes them.
double area(const PlanarDomain& domain);

}  // namespace mdbd
