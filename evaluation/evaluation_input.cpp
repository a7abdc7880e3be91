#include "evaluation/evaluation_input.h"

#include <fmt/format.h>

#include "features/core/errors.h"
#include "features/descriptor/similarity_distance.h"

namespace mdbd {

CleanModels describe_clean_models(const EvaluationInput& input) {
  const std::vector<LabelledModel>& models = input.collection.models;
  DescribedModels described = input.cache.describe(models, clean_variant());
  CleanModels clean;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!described[i]) continue;
    clean.models.push_back(models[i]);
    clean.descriptions.push_back(std::move(*described[i]));
  }
  if (clean.models.empty()) {
    throw InvalidInput(
        fmt::format("{}: none of the {} models could be described; the first: {}: {}",
                    input.collection.folder.string(), models.size(),
                    input.cache.failures().front().model, input.cache.failures().front().reason));
  }
  return clean;
}

DistanceMatrix similarity_matrix(const CleanModels& clean, const Recipe& recipe) {
  const std::vector<DescribedModel>& models = clean.descriptions;
  DistanceMatrix matrix(models.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      matrix(i, j) = matrix(j, i) = similarity_distance(models[i].descriptor, models[j].descriptor,
                                                        recipe.descriptor_balls, recipe.walk_weight)
                                        .total;
    }
  }
  return matrix;
}

}  // namespace mdbd
