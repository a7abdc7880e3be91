#pragma once

#include <cstddef>
#include <vector>

#include "evaluation/certificate/recheck.h"
#include "evaluation/evaluation_input.h"

namespace mdbd {

/// What re-checking one model found.
struct CheckedModel {
  LabelledModel model;
  std::size_t triangles = 0;
  std::size_t balls = 0;
  /// Whether the surface has no hole and its triangles agree on what is outside: only then is
  /// "inside" beyond dispute and maximality promised.
  bool is_closed = false;
  RecheckedBalls result;
};

/// Re-checks the decompositions of all models, each in a process of its own with a seed of its own;
/// models that fail are among the failures of the cache.
/// @param options the seed is not used
/// @throws as describe_clean_models and ModelCache::run, and InvalidInput if all models fail
std::vector<CheckedModel> check_models(const EvaluationInput& input, const RecheckOptions& options);

}  // namespace mdbd
