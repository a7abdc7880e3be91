#include "evaluation/reports/representations_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "evaluation/reports/varied_models.h"
#include "features/cloud_shape.h"
#include "perturbation/surface_sampling.h"

using nlohmann::ordered_json;

namespace mdbd {
namespace {

/// The meshes of a collection, and clouds of each.
struct CloudStudy {
  CleanModels clean;
  std::vector<VariedModels> clouds;  ///< one for each sampling
  std::vector<SignatureComparison> signatures;
};

std::vector<CloudSampling> all_samplings(const RepresentationsOptions& options) {
  std::vector<CloudSampling> samplings;
  for (const std::size_t points : options.points) samplings.push_back({points, 0.0});
  samplings.push_back({options.noisy_points, options.noise});
  return samplings;
}

std::string name_of(const CloudSampling& sampling) {
  const std::string name = fmt::format("cloud of {} points", sampling.points);
  return sampling.noise > 0 ? fmt::format("{}, noise {} %", name, sampling.noise) : name;
}

Variant cloud_variant(const CloudSampling& sampling, std::uint64_t seed) {
  return {.name = fmt::format("{}, seed {}", name_of(sampling), seed),
          .load = [sampling, seed](const std::filesystem::path& path, const Recipe&) {
            return make_cloud_shape(sample_file(path, sampling, seed));
          }};
}

CloudStudy study_clouds(const EvaluationInput& input, const RepresentationsOptions& options) {
  CloudStudy study{.clean = describe_clean_models(input), .clouds = {}, .signatures = {}};
  for (const CloudSampling& sampling : all_samplings(options)) {
    study.clouds.push_back(describe_varied(input, study.clean, name_of(sampling),
                                           cloud_variant(sampling, input.seed)));
  }
  study.signatures = compare_signatures(input, study.clean, study.clouds);
  return study;
}

std::vector<std::string> score_row(const VariedModels& cloud) {
  if (!cloud.robustness) return {cloud.name, "0", "–", "–", "–", "–"};
  const Robustness& robustness = *cloud.robustness;
  return {cloud.name,
          std::to_string(robustness.models.size()),
          percent_text(robustness.self_first),
          percent_text(robustness.class_accuracy),
          number_text(robustness.displacement_median),
          number_text(robustness.displacement_90)};
}

Section score_section(const CloudStudy& study) {
  Table table{.caption = "Clouds, queried against the meshes",
              .columns = {"representation", "models", "self first %", "class NN %",
                          "displacement: median", "90 %"},
              .rows = {},
              .is_summary = true};
  for (const VariedModels& cloud : study.clouds) table.rows.push_back(score_row(cloud));
  return {"Scores",
          {std::move(table),
           Paragraph{"Self first: no other model is nearer to the cloud than the mesh that it was "
                     "drawn from. Class NN: the nearest other mesh is of its class. Displacement: "
                     "distance from the cloud to its mesh, relative to the distance from that to "
                     "the nearest other mesh; median, and what 90 % of the models stay below."}}};
}

double better_rate(const SignatureComparison& comparison) {
  double best = 0.0;
  for (const auto& robustness : {comparison.mdbd_100, comparison.mdbd_fused}) {
    if (robustness) best = std::max(best, robustness->self_first);
  }
  return best;
}

std::string summarise(const CloudStudy& study) {
  std::string text = fmt::format(
      "How many of {} models are found first by a cloud of their own, with the better signature:",
      study.clean.models.size());
  for (const SignatureComparison& comparison : study.signatures) {
    text += fmt::format("{} {} % ({})", &comparison == &study.signatures.front() ? "" : ",",
                        percent_text(better_rate(comparison)), comparison.change);
  }
  return text + ".";
}

ordered_json to_json(const CloudStudy& study, const EvaluationInput& input) {
  const Recipe& recipe = input.cache.recipe();
  ordered_json clouds = ordered_json::array();
  for (const VariedModels& cloud : study.clouds) clouds.push_back(to_json(study.clean, cloud));
  return {{"seed", input.seed},
          {"signature", to_string(input.signature)},
          {"radius_count", recipe.descriptor_balls},
          {"walk_weight", recipe.walk_weight},
          {"changes", std::move(clouds)},
          {"models", to_json(study.clean)},
          {"signatures", to_json(study.signatures)}};
}

}  // namespace

Report make_representations_report(const EvaluationInput& input,
                                   const RepresentationsOptions& options) {
  const CloudStudy study = study_clouds(input, options);
  Report report;
  report.title = "Representations on " + input.collection.folder.filename().string();
  report.summary = summarise(study);
  report.notes = variation_notes(study.clean, study.clouds);
  report.sections = {score_section(study),
                     {"Both signatures", {signatures_table(study.signatures)}},
                     {"Models that moved the furthest",
                      {worst_models_table(study.clean, study.clouds, options.worst)}}};
  report.data = to_json(study, input);
  return report;
}

}  // namespace mdbd
