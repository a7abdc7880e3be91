#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "evaluation/evaluation_input.h"
#include "evaluation/measures/robustness.h"
#include "perturbation/perturbation.h"
#include "report/report.h"

/// What the reports on changed copies of models have in common.
namespace mdbd {

/// The models of a collection after a change, and how they fared.
struct VariedModels {
  std::string name;        ///< of the change, with its parameters: "noise 0.5 %"
  DescribedModels models;  ///< one for each of CleanModels::models; empty where it failed
  std::optional<Robustness> robustness;  ///< empty if all models failed
};

/// The variant that perturb_file() makes of every model with a seed: the copies that mdbd-perturb
/// writes.
Variant perturbed_variant(const Perturbation& perturbation, std::uint64_t seed);

/// Describes the changed copies of models and compares them with the models.
/// @throws as ModelCache::describe
VariedModels describe_varied(const EvaluationInput& input, const CleanModels& clean,
                             const Perturbation& perturbation);

/// Describes any variants of models and compares them with the models.
/// @param name of the change, for the report
/// @throws as ModelCache::describe
VariedModels describe_varied(const EvaluationInput& input, const CleanModels& clean,
                             const std::string& name, const Variant& variant);

/// The models as they are, queried against themselves: what the measures are compared with.
VariedModels unvaried_models(const EvaluationInput& input, const CleanModels& clean);

/// The faces of each changed copy (a mesh) relative to those of its model; empty where it failed.
std::vector<std::optional<double>> face_ratios(const CleanModels& clean,
                                               const VariedModels& varied);

/// The models that moved the furthest, relative to the distance to their nearest other model.
Table worst_models_table(const CleanModels& clean, std::span<const VariedModels> variations,
                         std::size_t count);

/// How a change is borne by each signature, on the same copies of the same models.
struct SignatureComparison {
  std::string change;
  std::optional<Robustness> mdbd_100;  ///< empty if all models failed
  std::optional<Robustness> mdbd_fused;
};

/// One for each variation; the signature that is not measured is computed from the balls.
std::vector<SignatureComparison> compare_signatures(const EvaluationInput& input,
                                                    const CleanModels& clean,
                                                    std::span<const VariedModels> variations);

/// Self first and class NN by each signature.
Table signatures_table(std::span<const SignatureComparison> comparisons);

/// [{"change", "mdbd-100": measures, "mdbd-fused": measures}, …]; null where all models failed.
nlohmann::ordered_json to_json(std::span<const SignatureComparison> comparisons);

/// What limits the meaning of the measures: failed copies, models alone in their class.
std::vector<std::string> variation_notes(const CleanModels& clean,
                                         std::span<const VariedModels> variations);

/// "97.4"; "–" if it is empty.
std::string percent_text(const std::optional<double>& rate);
/// Three decimals; "–" if it is empty.
std::string number_text(const std::optional<double>& number);

/// [{"name", "class", "scale", "descriptor"}, …], in order.
nlohmann::ordered_json to_json(const CleanModels& clean);

/// {"change", "measures", "mean_shift", "mean_absolute_shift", "models": [{"name", "scale",
/// "faces" (of a cloud "points"), "descriptor", "self_rank", …}, …]} with the models that did not
/// fail.
nlohmann::ordered_json to_json(const CleanModels& clean, const VariedModels& varied);

}  // namespace mdbd
