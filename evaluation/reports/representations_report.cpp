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
  std::vector<SignatureComparison> mixed;  ///< the clouds, queried against a mixed collection
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

/// The collection with a cloud in place of every second mesh.
CleanModels with_clouds(CleanModels models, const DescribedModels& clouds) {
  for (std::size_t i = 1; i < models.descriptions.size(); i += 2) {
    if (clouds[i]) models.descriptions[i] = *clouds[i];
  }
  return models;
}

CloudStudy study_clouds(const EvaluationInput& input, const RepresentationsOptions& options) {
  CloudStudy study{
      .clean = describe_clean_models(input), .clouds = {}, .signatures = {}, .mixed = {}};
  for (const CloudSampling& sampling : all_samplings(options)) {
    study.clouds.push_back(describe_varied(input, study.clean, name_of(sampling),
                                           cloud_variant(sampling, input.seed)));
  }
  study.signatures = compare_signatures(input, study.clean, study.clouds);
  const DescribedModels& densest = study.clouds[options.points.size() - 1].models;
  study.mixed = compare_signatures(input, with_clouds(study.clean, densest), study.clouds);
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

// The model itself is left out, so that its class has to be found by the others.
Section mixed_section(const CloudStudy& study) {
  Table table{.caption = "Clouds, queried against meshes and clouds of the other models",
              .columns = {"query", "mdbd-100: class NN %", "mdbd-fused: class NN %"},
              .rows = {},
              .is_summary = true};
  const auto accuracy = [](const std::optional<Robustness>& robustness) {
    return robustness ? percent_text(robustness->class_accuracy) : "–";
  };
  for (const SignatureComparison& query : study.mixed) {
    table.rows.push_back({query.change, accuracy(query.mdbd_100), accuracy(query.mdbd_fused)});
  }
  return {
      "Mixed representations",
      {std::move(table),
       Paragraph{"As in Figure 12 of the paper: every second model of the collection is a cloud "
                 "of the most points instead of its mesh. Class NN: the nearest model other "
                 "than the query itself is of its class."}}};
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
          {"signatures", to_json(study.signatures)},
          {"mixed", to_json(study.mixed)}};
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
                     mixed_section(study),
                     {"Models that moved the furthest",
                      {worst_models_table(study.clean, study.clouds, options.worst)}}};
  report.data = to_json(study, input);
  return report;
}

}  // namespace mdbd
