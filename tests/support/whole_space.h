#pragma once

#include "features/decomposition/remaining_space.h"

namespace mdbd::test {

/// The space in a solid before the first ball, with the preference that decompose() begins with.
inline RemainingSpace whole_space(const DistanceField& field) {
  constexpr double weight = 1e-4;
  return {field, Preference::outward(field.enclosing_ball(), weight)};
}

}  // namespace mdbd::test
