#pragma once

#include "features/brep/brep.h"

namespace mdbd {

/// Divides triangles that are farther from their surface than a deflection, which a tessellation
/// wishes for but does not always reach. Sides on the outlines of faces stay as they are.
/// @param deflection object units
/// @throws InvalidInput if a surface cannot be evaluated
void refine_tessellation(Brep& brep, double deflection);

}  // namespace mdbd
