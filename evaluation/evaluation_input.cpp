#include "evaluation/evaluation_input.h"

#include <fmt/format.h>

#include "evaluation/signature_terms.h"
#include "features/core/errors.h"
#include "features/descriptor/compute_descriptor.h"
#include "features/descriptor/fused_signature.h"

namespace mdbd {

std::vector<float> signature_of(std::span<const Ball> balls, double scale, SignatureKind signature,
                                const Recipe& recipe) {
  if (signature == SignatureKind::mdbd_fused) return compute_fused_signature(balls);
  BallDecomposition decomposition;
  decomposition.balls.assign(balls.begin(), balls.end());
  decomposition.scale = scale;
  return compute_descriptor(decomposition, recipe).values;
}

DescribedModels describe_models(const EvaluationInput& input, std::span<const LabelledModel> models,
                                const Variant& variant) {
  DescribedModels described = input.cache.describe(models, variant);
  if (input.signature == SignatureKind::mdbd_fused) {
    for (auto& model : described) {
      if (model) model->descriptor = compute_fused_signature(model->balls);
    }
  }
  return described;
}

CleanModels describe_clean_models(const EvaluationInput& input) {
  const std::vector<LabelledModel>& models = input.collection.models;
  DescribedModels described = describe_models(input, models, clean_variant());
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

DistanceMatrix signature_matrix(const EvaluationInput& input, const CleanModels& clean) {
  std::vector<std::vector<float>> vectors;
  for (const DescribedModel& model : clean.descriptions) vectors.push_back(model.descriptor);
  return vector_distances(vectors, signature_terms(input.signature, input.cache.recipe()));
}

}  // namespace mdbd
