#include "evaluation/reports/retrieval_report.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "evaluation/counted.h"
#include "evaluation/reports/class_bands.h"
#include "evaluation/reports/retrieval_methods.h"

using nlohmann::ordered_json;

namespace mdbd {
namespace {

/// A measure that is one number, with its names.
struct Measure {
  const char* column;
  const char* name;
  double RetrievalScores::*value;
};

constexpr std::array measures = {
    Measure{"NN", "nearest_neighbour", &RetrievalScores::nearest_neighbour},
    Measure{"FT", "first_tier", &RetrievalScores::first_tier},
    Measure{"ST", "second_tier", &RetrievalScores::second_tier},
    Measure{"E", "e_measure", &RetrievalScores::e_measure},
    Measure{"DCG", "discounted_gain", &RetrievalScores::discounted_gain},
    Measure{"mAP", "average_precision", &RetrievalScores::average_precision}};

std::string percent(double share) { return fmt::format("{:.1f}", 100 * share); }

void append_scores(std::vector<std::string>& row, const RetrievalScores& scores) {
  for (const Measure& measure : measures) row.push_back(percent(scores.*measure.value));
}

std::vector<std::string> titles(std::vector<std::string> first) {
  for (const Measure& measure : measures) first.emplace_back(measure.column);
  return first;
}

const RetrievalMethod& measured(const RetrievalComparison& comparison) {
  return comparison.methods[comparison.measured];
}

// ---- Tables and pictures ----

Table score_table(const RetrievalComparison& comparison, std::string caption,
                  RetrievalScores RetrievalMeasures::*average) {
  Table table{.caption = std::move(caption), .columns = titles({"method"}), .rows = {}};
  for (const RetrievalMethod& method : comparison.methods) {
    std::vector<std::string> row = {method.name};
    append_scores(row, method.measures.*average);
    table.rows.push_back(std::move(row));
  }
  return table;
}

Section score_section(const RetrievalComparison& comparison) {
  const RetrievalMeasures& any = comparison.methods.front().measures;
  Table summary =
      score_table(comparison, fmt::format("Mean over {} queries, per cent", any.queries),
                  &RetrievalMeasures::mean);
  summary.is_summary = true;
  Table by_class =
      score_table(comparison, fmt::format("Mean over {} classes, per cent", any.classes.size()),
                  &RetrievalMeasures::class_mean);
  return {"Scores",
          {std::move(summary), std::move(by_class),
           Paragraph{"Every model queries all the others. NN: the first answer is of the query's "
                     "class. FT, ST: the share of its class, of n others, among the first n and 2n "
                     "answers. E: precision and recall of the first 32 answers in one. DCG: "
                     "discounted cumulative gain relative to the best answer. mAP: mean average "
                     "precision. Princeton Shape Benchmark (Shilane et al. 2004)."}}};
}

Section precision_section(const RetrievalComparison& comparison) {
  LineChart chart{.caption = "Precision against recall, mean over queries",
                  .x_label = "recall",
                  .y_label = "precision",
                  .series = {},
                  .has_unit_range = true};
  for (const RetrievalMethod& method : comparison.methods) {
    LineSeries series{.name = method.name, .x = {}, .y = {}};
    for (std::size_t level = 0; level < recall_levels; ++level) {
      series.x.push_back(static_cast<double>(level + 1) / recall_levels);
      series.y.push_back(method.measures.mean.precision[level]);
    }
    chart.series.push_back(std::move(series));
  }
  return {"Precision and recall", {std::move(chart)}};
}

MatrixPicture matrix_picture(const RetrievalComparison& comparison, const RetrievalMethod& method) {
  const std::size_t size = method.distances.size();
  MatrixPicture picture{.caption = "Distances by " + method.name,
                        .size = size,
                        .values = {},
                        .bands = class_bands(comparison.models)};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) picture.values.push_back(method.distances(i, j));
  }
  return picture;
}

const RetrievalMethod* best_rival(const RetrievalComparison& comparison) {
  const RetrievalMethod* best = nullptr;
  for (const RetrievalMethod& method : comparison.methods) {
    if (!method.is_rival) continue;
    const auto score = [](const RetrievalMethod& m) { return m.measures.mean.average_precision; };
    if (best == nullptr || score(method) > score(*best)) best = &method;
  }
  return best;
}

Section distance_section(const RetrievalComparison& comparison) {
  Section section{"Distances", {matrix_picture(comparison, measured(comparison))}};
  if (const RetrievalMethod* rival = best_rival(comparison)) {
    section.blocks.emplace_back(matrix_picture(comparison, *rival));
  }
  return section;
}

/// All measures of the signature; of the rivals how often the first answer is right.
Section class_section(const RetrievalComparison& comparison) {
  const RetrievalMethod& own_method = measured(comparison);
  std::vector<const RetrievalMethod*> rivals;
  for (const RetrievalMethod& method : comparison.methods) {
    if (method.is_rival) rivals.push_back(&method);
  }
  Table table{.caption = own_method.name + " by class, per cent",
              .columns = titles({"class", "models"}),
              .rows = {}};
  for (const RetrievalMethod* rival : rivals) table.columns.push_back("NN " + rival->name);
  for (std::size_t c = 0; c < own_method.measures.classes.size(); ++c) {
    const ClassRetrieval& own = own_method.measures.classes[c];
    std::vector<std::string> row = {own.label, std::to_string(own.models)};
    append_scores(row, own.mean);
    for (const RetrievalMethod* rival : rivals) {
      row.push_back(percent(rival->measures.classes[c].mean.nearest_neighbour));
    }
    table.rows.push_back(std::move(row));
  }
  return {"Classes", {std::move(table)}};
}

// ---- Confusions ----

/// A query whose first answer is of another class.
struct Confusion {
  std::size_t query = 0;
  std::size_t wrong = 0;  ///< the first answer
  std::size_t right = 0;  ///< the first answer of the query's class
  std::size_t rank = 0;   ///< of that answer, from 1
  double wrong_distance = 0.0;
  double right_distance = 0.0;
};

/// The worst first: the largest ratio of the distances of the right and the wrong answer.
std::vector<Confusion> find_confusions(const RetrievalComparison& comparison) {
  const DistanceMatrix& distances = measured(comparison).distances;
  const std::vector<LabelledModel>& models = comparison.models;
  std::vector<Confusion> confusions;
  for (std::size_t query = 0; query < models.size(); ++query) {
    const std::vector<std::size_t> ranking = rank_models(distances, query);
    const auto right = std::ranges::find_if(
        ranking, [&](std::size_t model) { return models[model].label == models[query].label; });
    if (right == ranking.begin() || right == ranking.end()) continue;
    const std::size_t wrong = ranking.front();
    confusions.push_back({query, wrong, *right,
                          static_cast<std::size_t>(right - ranking.begin()) + 1,
                          distances(query, wrong), distances(query, *right)});
  }
  std::ranges::stable_sort(confusions, [](const Confusion& a, const Confusion& b) {
    return a.right_distance * b.wrong_distance > b.right_distance * a.wrong_distance;
  });
  return confusions;
}

Section confusion_section(const RetrievalComparison& comparison,
                          std::span<const Confusion> confusions, std::size_t count) {
  const std::vector<LabelledModel>& models = comparison.models;
  const std::span<const Confusion> worst = confusions.first(std::min(count, confusions.size()));
  Table table{
      .caption = fmt::format("The {} worst of {} queries whose first answer is of another "
                             "class, by {}",
                             worst.size(), confusions.size(), measured(comparison).name),
      .columns = {"query", "first answer", "distance", "first of its class", "distance", "rank"},
      .rows = {}};
  for (const Confusion& confusion : worst) {
    table.rows.push_back(
        {models[confusion.query].name, models[confusion.wrong].name,
         fmt::format("{:.4f}", confusion.wrong_distance), models[confusion.right].name,
         fmt::format("{:.4f}", confusion.right_distance), std::to_string(confusion.rank)});
  }
  return {"Worst confusions", {std::move(table)}};
}

// ---- Numbers for programs ----

ordered_json to_json(const RetrievalScores& scores) {
  ordered_json object;
  for (const Measure& measure : measures) object[measure.name] = scores.*measure.value;
  object["precision"] = scores.precision;
  return object;
}

ordered_json to_json(const RetrievalMethod& method) {
  ordered_json terms = ordered_json::array();
  for (const DistanceTerm& term : method.terms) {
    terms.push_back({{"norm", to_string(term.norm)},
                     {"first", term.first},
                     {"count", term.count},
                     {"weight", term.weight}});
  }
  ordered_json classes = ordered_json::array();
  for (const ClassRetrieval& one : method.measures.classes) {
    classes.push_back({{"class", one.label}, {"models", one.models}, {"mean", to_json(one.mean)}});
  }
  return {{"name", method.name},
          {"vectors", method.signature},
          {"distance", std::move(terms)},
          {"mean", to_json(method.measures.mean)},
          {"class_mean", to_json(method.measures.class_mean)},
          {"classes", std::move(classes)}};
}

ordered_json confusions_to_json(const RetrievalComparison& comparison,
                                std::span<const Confusion> confusions) {
  ordered_json list = ordered_json::array();
  for (const Confusion& confusion : confusions) {
    list.push_back({{"query", comparison.models[confusion.query].name},
                    {"first_answer", comparison.models[confusion.wrong].name},
                    {"first_answer_distance", confusion.wrong_distance},
                    {"first_of_class", comparison.models[confusion.right].name},
                    {"first_of_class_distance", confusion.right_distance},
                    {"first_of_class_rank", confusion.rank}});
  }
  return list;
}

ordered_json models_to_json(const RetrievalComparison& comparison) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < comparison.models.size(); ++i) {
    ordered_json vectors;
    for (const ComparedSignature& signature : comparison.signatures) {
      vectors[signature.name] = signature.vectors[i];
    }
    list.push_back({{"name", comparison.models[i].name},
                    {"class", comparison.models[i].label},
                    {"vectors", std::move(vectors)}});
  }
  return list;
}

ordered_json to_json(const RetrievalComparison& comparison, std::span<const Confusion> confusions) {
  const RetrievalMeasures& any = comparison.methods.front().measures;
  ordered_json methods = ordered_json::array();
  for (const RetrievalMethod& method : comparison.methods) methods.push_back(to_json(method));
  return {{"signature", measured(comparison).name},
          {"queries", any.queries},
          {"left_out_queries", any.left_out},
          {"recall_levels", recall_levels},
          {"methods", std::move(methods)},
          {"confusions", confusions_to_json(comparison, confusions)},
          {"models", models_to_json(comparison)}};
}

// ---- In words ----

std::string summarise(const RetrievalComparison& comparison) {
  const RetrievalMethod& own_method = measured(comparison);
  const RetrievalMeasures& own = own_method.measures;
  std::string others;
  for (const RetrievalMethod& method : comparison.methods) {
    if (&method == &own_method) continue;
    others += fmt::format("{}{} {} %", others.empty() ? "" : ", ", method.name,
                          percent(method.measures.mean.nearest_neighbour));
  }
  return fmt::format(
      "The first answer of {} is of the query's class for {} % of {} queries in {} ({}).",
      own_method.name, percent(own.mean.nearest_neighbour), own.queries,
      counted(own.classes.size(), "class", "es"), others);
}

std::vector<std::string> make_notes(const RetrievalComparison& comparison) {
  std::vector<std::string> notes;
  if (comparison.left_out > 0) {
    notes.push_back(fmt::format("{} on which a rival failed left out for all methods.",
                                counted(comparison.left_out, "model")));
  }
  const RetrievalMeasures& any = comparison.methods.front().measures;
  if (any.left_out > 0) {
    notes.push_back(
        fmt::format("{} without another of the same class not queried, but among the "
                    "answers.",
                    counted(any.left_out, "model")));
  } else if (any.classes.size() == 1) {
    notes.push_back(
        "There is one class only: every answer is right, and the measures say nothing.");
  }
  return notes;
}

}  // namespace

Report make_retrieval_report(const EvaluationInput& input, const RetrievalOptions& options) {
  const RetrievalComparison comparison = compare_retrieval(input, options.has_rivals);
  const std::vector<Confusion> confusions = find_confusions(comparison);
  Report report;
  report.title = "Retrieval on " + input.collection.folder.filename().string();
  report.summary = summarise(comparison);
  report.notes = make_notes(comparison);
  report.sections = {score_section(comparison), precision_section(comparison),
                     distance_section(comparison), class_section(comparison),
                     confusion_section(comparison, confusions, options.confusions)};
  report.data = to_json(comparison, confusions);
  return report;
}

}  // namespace mdbd
