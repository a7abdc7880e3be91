#pragma once

#include <vector>

#include "evaluation/measures/vector_distance.h"
#include "features/core/recipe.h"

namespace mdbd {

/// The distance by which a signature is compared, as mdbd-query does: of mdbd-100 the similarity
/// distance (paper, section 5.2), the radii's term first; of mdbd-fused the L1 distance.
std::vector<DistanceTerm> signature_terms(SignatureKind signature, const Recipe& recipe);

}  // namespace mdbd
