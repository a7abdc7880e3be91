#include "evaluation/reports/noise_report.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "evaluation/reports/class_bands.h"
#include "evaluation/reports/varied_models.h"
#include "evaluation/signature_terms.h"
#include "features/core/errors.h"
#include "features/descriptor/fused_signature.h"

using nlohmann::ordered_json;

namespace mdbd {
namespace {

constexpr std::size_t default_queries = 4;  // as in the paper

/// All that the report tells.
struct NoiseStudy {
  CleanModels clean;
  VariedModels unvaried;
  std::vector<double> levels;
  std::vector<VariedModels> noisy;  ///< one for each level
  std::vector<std::size_t> queries;
  Recipe recipe;
  SignatureKind signature = SignatureKind::mdbd_100;
};

/// A query's distances to all models.
struct QueryDistances {
  std::vector<double> clean;
  std::vector<std::optional<std::vector<double>>> noisy;  ///< for each level; empty if it failed
};

void require_usable(const NoiseOptions& options) {
  if (options.levels.empty()) throw InvalidInput("no level of noise is given");
  for (const double level : options.levels) {
    if (!(level >= 0 && level <= 100)) {
      throw InvalidInput(fmt::format("a level of noise must be from 0 to 100 %, not {}", level));
    }
  }
}

/// The first models of some classes, evenly spread.
std::vector<std::size_t> choose_queries(const CleanModels& clean) {
  std::vector<std::size_t> first_models;
  std::size_t next = 0;
  for (const Band& band : class_bands(clean.models)) {
    first_models.push_back(next);
    next += band.count;
  }
  const std::size_t count = std::min(default_queries, first_models.size());
  std::vector<std::size_t> queries;
  for (std::size_t i = 0; i < count; ++i) {
    queries.push_back(first_models[i * first_models.size() / count]);
  }
  return queries;
}

std::vector<std::size_t> find_queries(const CleanModels& clean,
                                      const std::vector<std::string>& names) {
  std::vector<std::size_t> queries;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(clean.models, name, &LabelledModel::name);
    if (found == clean.models.end()) {
      throw InvalidInput(fmt::format(
          "the query {} is no model of the collection that could be described; models are named by "
          "their path in it, such as {}",
          name, clean.models.front().name));
    }
    queries.push_back(static_cast<std::size_t>(found - clean.models.begin()));
  }
  return queries;
}

NoiseStudy study_noise(const EvaluationInput& input, const NoiseOptions& options) {
  require_usable(options);
  NoiseStudy study;
  study.recipe = input.cache.recipe();
  study.signature = input.signature;
  study.clean = describe_clean_models(input);
  study.queries = options.queries.empty() ? choose_queries(study.clean)
                                          : find_queries(study.clean, options.queries);
  study.unvaried = unvaried_models(input, study.clean);
  study.levels = options.levels;
  for (const double level : options.levels) {
    study.noisy.push_back(describe_varied(input, study.clean, noise_perturbation(level)));
  }
  return study;
}

QueryDistances distances_of(const NoiseStudy& study, std::size_t query) {
  std::vector<std::vector<float>> clean;
  for (const DescribedModel& model : study.clean.descriptions) clean.push_back(model.descriptor);
  const std::vector<DistanceTerm> terms = signature_terms(study.signature, study.recipe);
  const auto distances = [&](const std::vector<float>& descriptor) {
    return distances_to(clean, descriptor, terms);
  };
  QueryDistances result{.clean = distances(clean[query]), .noisy = {}};
  for (const VariedModels& varied : study.noisy) {
    const auto& model = varied.models[query];
    result.noisy.push_back(model ? std::optional(distances(model->descriptor)) : std::nullopt);
  }
  return result;
}

// ---- Tables and charts ----

std::vector<std::string> score_row(const VariedModels& varied) {
  if (!varied.robustness) return {varied.name, "0", "–", "–", "–", "–", "–", "–"};
  const Robustness& robustness = *varied.robustness;
  return {varied.name,
          std::to_string(robustness.models.size()),
          percent_text(robustness.self_first),
          percent_text(robustness.class_accuracy),
          number_text(robustness.rank_correlation_mean),
          number_text(robustness.rank_correlation_min),
          number_text(robustness.displacement_median),
          number_text(robustness.displacement_90)};
}

Section score_section(const NoiseStudy& study) {
  Table table{.caption = "Noisy models, queried against the clean collection",
              .columns = {"models", "count", "self first %", "class NN %", "rank corr.", "lowest",
                          "displacement: median", "90 %"},
              .rows = {score_row(study.unvaried)},
              .is_summary = true};
  for (const VariedModels& varied : study.noisy) table.rows.push_back(score_row(varied));
  return {
      "Scores",
      {std::move(table),
       Paragraph{"Every vertex is moved by a random vector, uniform in a ball whose radius is "
                 "the given percentage of the diameter of the smallest ball around the model "
                 "(MeshLab's random vertex displacement). Self first: no other model is nearer "
                 "to the noisy model than the clean one that it was made of. Class NN: the "
                 "nearest other model is of its class. Rank correlation (Spearman): of its "
                 "distances to all other models with those of the clean model; mean and lowest. "
                 "Displacement: distance from the noisy to the clean model, relative to the "
                 "distance from the clean model to the nearest other; median, and what "
                 "90 % of the models stay below."}}};
}

std::string number_label(const NoiseStudy& study) {
  if (study.signature == SignatureKind::mdbd_100) {
    return fmt::format("number of the descriptor: 1 to {} are radii, the others walk sums",
                       study.recipe.descriptor_balls);
  }
  std::string label = "number of the signature:";
  for (const SignaturePart& part : fused_parts) {
    label += fmt::format(" {} from {}", part.name, part.first + 1);
  }
  return label;
}

LineChart shift_chart(const NoiseStudy& study, std::string caption, std::string y_label,
                      std::vector<double> Robustness::*shift) {
  LineChart chart{.caption = std::move(caption),
                  .x_label = number_label(study),
                  .y_label = std::move(y_label),
                  .series = {}};
  for (const VariedModels& varied : study.noisy) {
    if (!varied.robustness) continue;
    const std::vector<double>& y = (*varied.robustness).*shift;
    std::vector<double> x(y.size());
    std::iota(x.begin(), x.end(), 1.0);
    chart.series.push_back({varied.name, std::move(x), y});
  }
  return chart;
}

Section shift_section(const NoiseStudy& study) {
  return {"Shift of the numbers",
          {shift_chart(study, "How far each number moves, mean over models", "mean of |shift|",
                       &Robustness::mean_absolute_shift),
           shift_chart(study, "In which direction, mean over models", "mean of noisy - clean",
                       &Robustness::mean_shift)}};
}

/// "chair/1.off: rank correlation 0.991 with noise 0.5 %, rank correlation …".
std::string query_caption(const NoiseStudy& study, std::size_t query) {
  std::string text = study.clean.models[query].name;
  const char* gap = ": ";
  for (const VariedModels& varied : study.noisy) {
    text += std::exchange(gap, ", ");
    if (!varied.models[query]) {
      text += fmt::format("could not be described with {}", varied.name);
      continue;
    }
    const auto& models = varied.robustness->models;
    const auto model = std::ranges::find(models, query, &ModelRobustness::model);
    text += fmt::format("rank correlation {} with {}", number_text(model->rank_correlation),
                        varied.name);
    if (model->self_rank > 1) text += fmt::format(" (itself at rank {})", model->self_rank);
  }
  return text;
}

BarChart query_chart(const NoiseStudy& study, std::size_t query) {
  const QueryDistances distances = distances_of(study, query);
  BarChart chart{.caption = query_caption(study, query),
                 .y_label = "distance",
                 .categories = {},
                 .bands = class_bands(study.clean.models),
                 .series = {{"clean", distances.clean}}};
  for (const LabelledModel& model : study.clean.models) chart.categories.push_back(model.name);
  for (std::size_t i = 0; i < study.noisy.size(); ++i) {
    if (distances.noisy[i]) chart.series.push_back({study.noisy[i].name, *distances.noisy[i]});
  }
  return chart;
}

Section query_section(const NoiseStudy& study) {
  Section section{"Distances to all models, clean beside noisy", {}};
  for (const std::size_t query : study.queries) {
    section.blocks.emplace_back(query_chart(study, query));
  }
  section.blocks.emplace_back(
      Paragraph{"As in the paper's Figure 13: if the distribution over the models stays the same, "
                "noise does not change what is found."});
  return section;
}

// ---- Numbers for programs ----

ordered_json query_to_json(const NoiseStudy& study, std::size_t query) {
  const QueryDistances distances = distances_of(study, query);
  ordered_json noisy = ordered_json::array();
  for (const auto& one : distances.noisy)
    noisy.push_back(one ? ordered_json(*one) : ordered_json());
  return {{"model", study.clean.models[query].name},
          {"clean_distances", distances.clean},
          {"noisy_distances", std::move(noisy)}};
}

ordered_json to_json(const NoiseStudy& study, std::uint64_t seed) {
  ordered_json noise = ordered_json::array();
  for (std::size_t i = 0; i < study.noisy.size(); ++i) {
    ordered_json one = {{"level", study.levels[i]}};
    one.update(to_json(study.clean, study.noisy[i]));
    noise.push_back(std::move(one));
  }
  ordered_json queries = ordered_json::array();
  for (const std::size_t query : study.queries) queries.push_back(query_to_json(study, query));
  return {{"seed", seed},
          {"signature", to_string(study.signature)},
          {"radius_count", study.recipe.descriptor_balls},
          {"walk_weight", study.recipe.walk_weight},
          {"clean_class_accuracy", study.unvaried.robustness->class_accuracy
                                       ? ordered_json(*study.unvaried.robustness->class_accuracy)
                                       : ordered_json()},
          {"noise", std::move(noise)},
          {"queries", std::move(queries)},
          {"models", to_json(study.clean)}};
}

// ---- In words ----

std::string summarise(const NoiseStudy& study) {
  std::string text =
      fmt::format("By {}, of {} models ", to_string(study.signature), study.clean.models.size());
  for (const VariedModels& varied : study.noisy) {
    const bool is_first = &varied == &study.noisy.front();
    const std::string rate = varied.robustness ? percent_text(varied.robustness->self_first) : "0";
    text += is_first
                ? fmt::format("{} % are found first by their copies with {}", rate, varied.name)
                : fmt::format(", {} % with {}", rate, varied.name);
  }
  return text + '.';
}

}  // namespace

Report make_noise_report(const EvaluationInput& input, const NoiseOptions& options) {
  const NoiseStudy study = study_noise(input, options);
  Report report;
  report.title = "Noise on " + input.collection.folder.filename().string();
  report.summary = summarise(study);
  report.notes = variation_notes(study.clean, study.noisy);
  const std::vector<SignatureComparison> signatures =
      compare_signatures(input, study.clean, study.noisy);
  report.sections = {score_section(study),
                     {"Both signatures", {signatures_table(signatures)}},
                     shift_section(study),
                     query_section(study),
                     {"Models that moved the furthest",
                      {worst_models_table(study.clean, study.noisy, options.worst)}}};
  report.data = to_json(study, input.seed);
  report.data["signatures"] = to_json(signatures);
  return report;
}

}  // namespace mdbd
