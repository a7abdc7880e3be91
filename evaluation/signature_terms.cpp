#include "evaluation/signature_terms.h"

#include "features/descriptor/fused_signature.h"

namespace mdbd {

std::vector<DistanceTerm> signature_terms(SignatureKind signature, const Recipe& recipe) {
  if (signature == SignatureKind::mdbd_fused) {
    return {{.norm = VectorNorm::l1, .count = fused_size}};
  }
  const auto radius_count = static_cast<std::size_t>(recipe.descriptor_balls);
  return {{.count = radius_count},
          {.first = radius_count,
           .count = static_cast<std::size_t>(recipe.walk_steps),
           .weight = recipe.walk_weight}};
}

}  // namespace mdbd
