#include "evaluation/reports/varied_models.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "evaluation/reports/class_bands.h"
#include "evaluation/signature_terms.h"
#include "features/mesh_shape.h"

using nlohmann::ordered_json;

namespace mdbd {
namespace {

Robustness measure(const CleanModels& clean, const DescribedModels& varied,
                   std::vector<DistanceTerm> terms) {
  RobustnessInput input{.clean = {}, .labels = {}, .varied = {}, .terms = std::move(terms)};
  for (std::size_t i = 0; i < clean.models.size(); ++i) {
    input.clean.push_back(clean.descriptions[i].descriptor);
    input.labels.push_back(clean.models[i].label);
    input.varied.push_back(varied[i] ? std::optional(varied[i]->descriptor) : std::nullopt);
  }
  return measure_robustness(input);
}

std::vector<DistanceTerm> distance_terms(const EvaluationInput& input) {
  return signature_terms(input.signature, input.cache.recipe());
}

DescribedModel with_signature(const DescribedModel& model, SignatureKind signature,
                              const Recipe& recipe) {
  DescribedModel result = model;
  result.descriptor = signature_of(model.balls, model.scale, signature, recipe);
  return result;
}

CleanModels with_signature(const CleanModels& clean, SignatureKind signature,
                           const Recipe& recipe) {
  CleanModels result{.models = clean.models, .descriptions = {}};
  for (const DescribedModel& model : clean.descriptions) {
    result.descriptions.push_back(with_signature(model, signature, recipe));
  }
  return result;
}

DescribedModels with_signature(const DescribedModels& models, SignatureKind signature,
                               const Recipe& recipe) {
  DescribedModels result;
  for (const auto& model : models) {
    result.push_back(model ? std::optional(with_signature(*model, signature, recipe))
                           : std::nullopt);
  }
  return result;
}

double face_count(const DescribedModel& model) {
  return ordered_json::parse(model.statistics).at("faces").get<double>();
}

/// What a model is made of: "faces", or "points" of a cloud.
std::pair<std::string, double> element_count(const DescribedModel& model) {
  const ordered_json statistics = ordered_json::parse(model.statistics);
  const std::string name = statistics.contains("faces") ? "faces" : "points";
  return {name, statistics.at(name).get<double>()};
}

std::size_t failed_copies(const VariedModels& varied) {
  return static_cast<std::size_t>(
      std::ranges::count_if(varied.models, [](const auto& model) { return !model; }));
}

template <typename Value>
ordered_json json_or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

ordered_json measures_to_json(const Robustness& robustness) {
  return {{"models", robustness.models.size()},
          {"self_first", robustness.self_first},
          {"class_accuracy", json_or_null(robustness.class_accuracy)},
          {"rank_correlation_mean", json_or_null(robustness.rank_correlation_mean)},
          {"rank_correlation_min", json_or_null(robustness.rank_correlation_min)},
          {"relative_displacement_median", json_or_null(robustness.displacement_median)},
          {"relative_displacement_mean", json_or_null(robustness.displacement_mean)},
          {"relative_displacement_90", json_or_null(robustness.displacement_90)}};
}

ordered_json model_to_json(const std::string& name, const DescribedModel& model,
                           const ModelRobustness& robustness) {
  const auto [elements, count] = element_count(model);
  return {{"name", name},
          {"scale", model.scale},
          {elements, count},
          {"self_rank", robustness.self_rank},
          {"class_found", json_or_null(robustness.is_class_found)},
          {"rank_correlation", json_or_null(robustness.rank_correlation)},
          {"displacement", robustness.displacement},
          {"relative_displacement", json_or_null(robustness.relative_displacement)},
          {"descriptor", model.descriptor}};
}

}  // namespace

Variant perturbed_variant(const Perturbation& perturbation, std::uint64_t seed) {
  return {.name = perturbation.is_random ? fmt::format("{}, seed {}", perturbation.name, seed)
                                         : perturbation.name,
          .load = [perturbation, seed](const std::filesystem::path& path, const Recipe& recipe) {
            return make_mesh_shape(perturb_file(path, perturbation, seed), recipe);
          }};
}

VariedModels describe_varied(const EvaluationInput& input, const CleanModels& clean,
                             const Perturbation& perturbation) {
  return describe_varied(input, clean, perturbation.name,
                         perturbed_variant(perturbation, input.seed));
}

VariedModels describe_varied(const EvaluationInput& input, const CleanModels& clean,
                             const std::string& name, const Variant& variant) {
  VariedModels varied{.name = name,
                      .models = describe_models(input, clean.models, variant),
                      .robustness = std::nullopt};
  if (failed_copies(varied) < varied.models.size()) {
    varied.robustness = measure(clean, varied.models, distance_terms(input));
  }
  return varied;
}

VariedModels unvaried_models(const EvaluationInput& input, const CleanModels& clean) {
  const DescribedModels models(clean.descriptions.begin(), clean.descriptions.end());
  return {.name = "as they are",
          .models = models,
          .robustness = measure(clean, models, distance_terms(input))};
}

std::vector<std::optional<double>> face_ratios(const CleanModels& clean,
                                               const VariedModels& varied) {
  std::vector<std::optional<double>> ratios;
  for (std::size_t i = 0; i < varied.models.size(); ++i) {
    const auto& model = varied.models[i];
    ratios.push_back(model ? std::optional(face_count(*model) / face_count(clean.descriptions[i]))
                           : std::nullopt);
  }
  return ratios;
}

Table worst_models_table(const CleanModels& clean, std::span<const VariedModels> variations,
                         std::size_t count) {
  std::vector<std::pair<const VariedModels*, const ModelRobustness*>> all;
  for (const VariedModels& varied : variations) {
    if (!varied.robustness) continue;
    for (const ModelRobustness& model : varied.robustness->models) {
      if (model.relative_displacement) all.emplace_back(&varied, &model);
    }
  }
  std::ranges::stable_sort(all, std::ranges::greater{},
                           [](const auto& entry) { return *entry.second->relative_displacement; });
  if (all.size() > count) all.resize(count);
  Table table{.caption = fmt::format("The {} copies that moved the furthest", all.size()),
              .columns = {"model", "change", "displacement", "relative to nearest other", "rank"},
              .rows = {}};
  for (const auto& [varied, model] : all) {
    table.rows.push_back(
        {clean.models[model->model].name, varied->name, number_text(model->displacement),
         number_text(model->relative_displacement), std::to_string(model->self_rank)});
  }
  return table;
}

std::vector<SignatureComparison> compare_signatures(const EvaluationInput& input,
                                                    const CleanModels& clean,
                                                    std::span<const VariedModels> variations) {
  const Recipe& recipe = input.cache.recipe();
  const bool is_fused = input.signature == SignatureKind::mdbd_fused;
  const SignatureKind other = is_fused ? SignatureKind::mdbd_100 : SignatureKind::mdbd_fused;
  const CleanModels clean_by_other = with_signature(clean, other, recipe);
  std::vector<SignatureComparison> comparisons;
  for (const VariedModels& varied : variations) {
    SignatureComparison& comparison = comparisons.emplace_back();
    comparison.change = varied.name;
    if (!varied.robustness) continue;
    (is_fused ? comparison.mdbd_fused : comparison.mdbd_100) = varied.robustness;
    (is_fused ? comparison.mdbd_100 : comparison.mdbd_fused) =
        measure(clean_by_other, with_signature(varied.models, other, recipe),
                signature_terms(other, recipe));
  }
  return comparisons;
}

Table signatures_table(std::span<const SignatureComparison> comparisons) {
  Table table{.caption = "Both signatures on the same copies",
              .columns = {"change", "mdbd-100: self first %", "class NN %",
                          "mdbd-fused: self first %", "class NN %"},
              .rows = {},
              .is_summary = true};
  for (const SignatureComparison& comparison : comparisons) {
    std::vector<std::string> row{comparison.change};
    for (const auto& robustness : {comparison.mdbd_100, comparison.mdbd_fused}) {
      row.push_back(robustness ? percent_text(robustness->self_first) : "–");
      row.push_back(robustness ? percent_text(robustness->class_accuracy) : "–");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ordered_json to_json(std::span<const SignatureComparison> comparisons) {
  const auto measures = [](const std::optional<Robustness>& robustness) {
    return robustness ? measures_to_json(*robustness) : ordered_json();
  };
  ordered_json list = ordered_json::array();
  for (const SignatureComparison& comparison : comparisons) {
    list.push_back({{"change", comparison.change},
                    {"mdbd-100", measures(comparison.mdbd_100)},
                    {"mdbd-fused", measures(comparison.mdbd_fused)}});
  }
  return list;
}

std::vector<std::string> variation_notes(const CleanModels& clean,
                                         std::span<const VariedModels> variations) {
  std::vector<std::string> notes;
  for (const VariedModels& varied : variations) {
    if (const std::size_t failed = failed_copies(varied); failed > 0) {
      notes.push_back(fmt::format("{}: {} of {} copies could not be described and are left out.",
                                  varied.name, failed, varied.models.size()));
    }
  }
  const std::vector<Band> classes = class_bands(clean.models);
  const auto alone = std::ranges::count(classes, std::size_t{1}, &Band::count);
  if (alone > 0) {
    notes.push_back(fmt::format(
        "{} model(s) without another of their class do not count for the accuracy of the class.",
        alone));
  }
  return notes;
}

std::string percent_text(const std::optional<double>& rate) {
  return rate ? fmt::format("{:.1f}", 100 * *rate) : "–";
}

std::string number_text(const std::optional<double>& number) {
  return number ? fmt::format("{:.3f}", *number) : "–";
}

ordered_json to_json(const CleanModels& clean) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < clean.models.size(); ++i) {
    list.push_back({{"name", clean.models[i].name},
                    {"class", clean.models[i].label},
                    {"scale", clean.descriptions[i].scale},
                    {"descriptor", clean.descriptions[i].descriptor}});
  }
  return list;
}

ordered_json to_json(const CleanModels& clean, const VariedModels& varied) {
  ordered_json object = {{"change", varied.name}};
  if (!varied.robustness) return object;
  object["measures"] = measures_to_json(*varied.robustness);
  object["mean_shift"] = varied.robustness->mean_shift;
  object["mean_absolute_shift"] = varied.robustness->mean_absolute_shift;
  ordered_json models = ordered_json::array();
  for (const ModelRobustness& model : varied.robustness->models) {
    models.push_back(
        model_to_json(clean.models[model.model].name, *varied.models[model.model], model));
  }
  object["models"] = std::move(models);
  return object;
}

}  // namespace mdbd
