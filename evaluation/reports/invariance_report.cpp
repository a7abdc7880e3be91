#include "evaluation/reports/invariance_report.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "evaluation/measures/statistics.h"
#include "evaluation/reports/varied_models.h"

using nlohmann::ordered_json;

namespace mdbd {
namespace {

/// A change, and the share of the faces that it should leave.
struct Change {
  Perturbation perturbation;
  double faces = 1.0;
};

struct VariedByChange {
  CleanModels clean;
  std::vector<Change> changes;
  std::vector<VariedModels> varied;  ///< one for each change
};

std::vector<Change> all_changes() {
  return {{rotation_perturbation()},
          {translation_perturbation(10)},
          {scale_perturbation(25.4)},  // from inches to millimetres
          {mirror_perturbation()},
          {export_perturbation(".stl")},
          {export_perturbation(".ply")},
          {export_perturbation(".obj")},
          {shuffling_perturbation()},
          {subdivision_perturbation(), 4.0},
          {decimation_perturbation(50), 0.5},
          {decimation_perturbation(10), 0.1}};
}

VariedByChange vary(const EvaluationInput& input) {
  VariedByChange study{
      .clean = describe_clean_models(input), .changes = all_changes(), .varied = {}};
  for (const Change& change : study.changes) {
    study.varied.push_back(describe_varied(input, study.clean, change.perturbation));
  }
  return study;
}

std::vector<double> present(const std::vector<std::optional<double>>& values) {
  std::vector<double> found;
  for (const auto& value : values) {
    if (value) found.push_back(*value);
  }
  return found;
}

std::optional<double> largest_displacement(const Robustness& robustness) {
  std::optional<double> largest;
  for (const ModelRobustness& model : robustness.models) {
    largest = std::max(largest, model.relative_displacement);
  }
  return largest;
}

// ---- Tables and charts ----

std::vector<std::string> score_row(const CleanModels& clean, const VariedModels& varied) {
  if (!varied.robustness) return {varied.name, "0", "–", "–", "–", "–", "–", "–"};
  const Robustness& robustness = *varied.robustness;
  return {varied.name,
          std::to_string(robustness.models.size()),
          percent_text(quantile(present(face_ratios(clean, varied)), 0.5)),
          percent_text(robustness.self_first),
          percent_text(robustness.class_accuracy),
          number_text(robustness.displacement_median),
          number_text(robustness.displacement_90),
          number_text(largest_displacement(robustness))};
}

Section score_section(const VariedByChange& study) {
  Table table{.caption = "Changed models, queried against the collection as it is",
              .columns = {"change", "models", "faces %", "self first %", "class NN %",
                          "displacement: median", "90 %", "largest"},
              .rows = {},
              .is_summary = true};
  for (const VariedModels& varied : study.varied) {
    table.rows.push_back(score_row(study.clean, varied));
  }
  return {
      "Scores",
      {std::move(table),
       Paragraph{"Faces: those of the changed model relative to its own, median. Self first: no "
                 "other model is nearer to the changed model than the one that it was made of. "
                 "Class NN: the nearest other model is of its class. Displacement: distance "
                 "from the changed model to its own, relative to the distance from that to the "
                 "nearest other; median, what 90 % of the models stay below, and largest."}}};
}

Section displacement_section(const VariedByChange& study) {
  BarChart chart{.caption = "Displacement relative to the nearest other model",
                 .y_label = "displacement / distance to the nearest other",
                 .categories = {},
                 .bands = {},
                 .series = {{"median", {}}, {"90 %", {}}}};
  for (const VariedModels& varied : study.varied) {
    if (!varied.robustness || !varied.robustness->displacement_median) continue;
    chart.categories.push_back(varied.name);
    chart.series[0].values.push_back(*varied.robustness->displacement_median);
    chart.series[1].values.push_back(*varied.robustness->displacement_90);
  }
  return {
      "Displacement",
      {std::move(chart), Paragraph{"Below 1/2 a model is sure to find itself: the distance is a "
                                   "metric, and no other model can be nearer."}}};
}

// ---- Notes, words and numbers ----

/// Decimation stops where no edge can be collapsed any more.
std::vector<std::string> face_notes(const VariedByChange& study) {
  constexpr double tolerance = 0.005;
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < study.changes.size(); ++i) {
    const double wanted = study.changes[i].faces;
    if (wanted >= 1) continue;
    const std::vector<double> reached = present(face_ratios(study.clean, study.varied[i]));
    const auto short_of =
        std::ranges::count_if(reached, [&](double share) { return share > wanted + tolerance; });
    if (short_of == 0) continue;
    notes.push_back(fmt::format(
        "{}: {} of {} models could not be decimated so far; the worst kept {:.1f} % of its faces.",
        study.varied[i].name, short_of, reached.size(), 100 * std::ranges::max(reached)));
  }
  return notes;
}

ordered_json to_json(const VariedByChange& study, const EvaluationInput& input) {
  const Recipe& recipe = input.cache.recipe();
  ordered_json changes = ordered_json::array();
  for (const VariedModels& varied : study.varied) changes.push_back(to_json(study.clean, varied));
  return {{"seed", input.seed},
          {"signature", to_string(input.signature)},
          {"radius_count", recipe.descriptor_balls},
          {"walk_weight", recipe.walk_weight},
          {"changes", std::move(changes)},
          {"models", to_json(study.clean)}};
}

std::string summarise(const VariedByChange& study) {
  const auto rate = [](const VariedModels& varied) {
    return varied.robustness ? varied.robustness->self_first : 0.0;
  };
  const auto worst = std::ranges::min_element(study.varied, {}, rate);
  if (rate(*worst) == 1) {
    return fmt::format("Every one of {} models finds itself first under all of {} changes.",
                       study.clean.models.size(), study.varied.size());
  }
  return fmt::format(
      "Of {} models, {} % find themselves first under the change that they bear worst, {}; all do "
      "under {} of {} changes.",
      study.clean.models.size(), percent_text(rate(*worst)), worst->name,
      std::ranges::count(study.varied, 1.0, rate), study.varied.size());
}

}  // namespace

Report make_invariance_report(const EvaluationInput& input, const InvarianceOptions& options) {
  const VariedByChange study = vary(input);
  Report report;
  report.title = "Invariance on " + input.collection.folder.filename().string();
  report.summary = summarise(study);
  report.notes = variation_notes(study.clean, study.varied);
  std::ranges::move(face_notes(study), std::back_inserter(report.notes));
  const std::vector<SignatureComparison> signatures =
      compare_signatures(input, study.clean, study.varied);
  report.sections = {score_section(study),
                     {"Both signatures", {signatures_table(signatures)}},
                     displacement_section(study),
                     {"Models that moved the furthest",
                      {worst_models_table(study.clean, study.varied, options.worst)}}};
  report.data = to_json(study, input);
  report.data["signatures"] = to_json(signatures);
  return report;
}

}  // namespace mdbd
