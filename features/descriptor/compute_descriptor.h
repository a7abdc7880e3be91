#pragma once

#include "features/core/descriptor.h"
#include "features/core/recipe.h"
#include "features/decomposition/ball_decomposition.h"

namespace mdbd {

/// The descriptor of a decomposition (paper, equation 4): radii divided by R, then walk sums.
/// @pre decomposition.scale > 0
Descriptor compute_descriptor(const BallDecomposition& decomposition, const Recipe& recipe);

}  // namespace mdbd
