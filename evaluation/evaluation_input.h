#pragma once

#include <cstdint>
#include <span>
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
  SignatureKind signature = SignatureKind::mdbd_100;  ///< the one that is measured
};

/// A signature of a model from its balls, as describing the model gives it.
/// @param scale R, object units, above 0
std::vector<float> signature_of(std::span<const Ball> balls, double scale, SignatureKind signature,
                                const Recipe& recipe);

/// The models of a collection that could be described as they are.
struct CleanModels {
  std::vector<LabelledModel> models;  ///< ordered by class, then by name
  /// One for each model; the descriptor is its vector of the signature that is measured.
  std::vector<DescribedModel> descriptions;
};

/// Describes models under a variant; the descriptors are vectors of the signature that is measured.
/// @throws as ModelCache::describe
DescribedModels describe_models(const EvaluationInput& input, std::span<const LabelledModel> models,
                                const Variant& variant);

/// @throws as ModelCache::describe, and InvalidInput if no model could be described
CleanModels describe_clean_models(const EvaluationInput& input);

/// The distances between all models by the signature that is measured.
DistanceMatrix signature_matrix(const EvaluationInput& input, const CleanModels& clean);

}  // namespace mdbd
