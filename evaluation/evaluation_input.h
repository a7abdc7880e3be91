#pragma once

#include <cstdint>
#include <vector>

#include "evaluation/distance_matrix.h"
#include "evaluation/labelled_collection.h"
#include "evaluation/model_cache.h"

namespace mdbd {

/// What every report starts from.
struct EvaluationInput {
  const LabelledCollection& collection;
  ModelCache& cache;
  std::uint64_t seed = 1;
};

/// The models of a collection that could be described as they are.
struct CleanModels {
  std::vector<LabelledModel> models;         ///< ordered by class, then by name
  std::vector<DescribedModel> descriptions;  ///< one for each model
};

/// @throws as ModelCache::describe, and InvalidInput if no model could be described
CleanModels describe_clean_models(const EvaluationInput& input);

/// The similarity distances between all models (paper, section 5.2).
DistanceMatrix similarity_matrix(const CleanModels& clean, const Recipe& recipe);

}  // namespace mdbd
