#include "evaluation/reports/classify_report.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "evaluation/counted.h"

using nlohmann::ordered_json;

namespace mdbd {
namespace {

// What the paper states in section 5.3, of all three parts together.
constexpr double paper_accuracy = 0.954;
constexpr int paper_balls = 800;

constexpr std::size_t paper_network = 0;
constexpr std::size_t own_network = 1;
constexpr std::size_t kernel = 2;
constexpr std::size_t neighbour = 3;

constexpr std::size_t listed_models = 20;

std::string percent(double share) { return fmt::format("{:.1f}", 100 * share); }

/// How a method did in each run.
struct MethodScores {
  std::string name;
  std::vector<double> test;     ///< accuracy on the test part, for each run
  std::vector<double> overall;  ///< over all three parts
  ConfusionCounts test_counts;  ///< of all runs
  ConfusionCounts overall_counts;
};

MethodScores score(const ClassificationComparison& comparison, const ClassificationMethod& method) {
  const std::size_t classes = comparison.classes.size();
  const ConfusionCounts zeros(classes, std::vector<std::size_t>(classes, 0));
  MethodScores scores{method.name, {}, {}, zeros, zeros};
  for (std::size_t run = 0; run < comparison.runs.size(); ++run) {
    const auto count = [&](std::optional<Part> part) {
      return count_confusions(comparison.labels, method.predicted[run], comparison.runs[run].parts,
                              part, classes);
    };
    const ConfusionCounts test = count(Part::test);
    const ConfusionCounts overall = count(std::nullopt);
    scores.test.push_back(accuracy(test));
    scores.overall.push_back(accuracy(overall));
    add_counts(scores.test_counts, test);
    add_counts(scores.overall_counts, overall);
  }
  return scores;
}

// ---- Tables and charts ----

void append_spread(std::vector<std::string>& row, std::span<const double> values) {
  const Spread spread = spread_of(values);
  row.push_back(percent(spread.mean));
  row.push_back(values.size() > 1 ? percent(spread.deviation) : "");
  row.push_back(percent(spread.lowest));
  row.push_back(percent(spread.highest));
}

Table accuracy_table(std::span<const MethodScores> methods, std::string caption,
                     std::vector<double> MethodScores::*values) {
  Table table{.caption = std::move(caption),
              .columns = {"method", "mean", "deviation", "lowest", "highest"},
              .rows = {},
              .is_summary = true};
  for (const MethodScores& method : methods) {
    std::vector<std::string> row{method.name};
    append_spread(row, method.*values);
    table.rows.push_back(std::move(row));
  }
  return table;
}

Section accuracy_section(const ClassificationComparison& comparison,
                         std::span<const MethodScores> methods) {
  const std::size_t runs = comparison.runs.size();
  const auto test = std::ranges::count(comparison.runs.front().parts, Part::test);
  Table on_test = accuracy_table(
      methods, fmt::format("Test part: {} models in each of {} runs, per cent right", test, runs),
      &MethodScores::test);
  Table over_all = accuracy_table(
      methods, fmt::format("All three parts: {} models, per cent right", comparison.models.size()),
      &MethodScores::overall);
  over_all.columns.emplace_back("paper");
  for (std::size_t i = 0; i < methods.size(); ++i) {
    over_all.rows[i].push_back(i == paper_network ? percent(paper_accuracy) : "");
  }
  return {
      "Accuracy",
      {std::move(on_test), std::move(over_all),
       Paragraph{fmt::format(
           "Only the test part tells how unknown models fare: a network has seen the labels of "
           "the training part and has been stopped by the validation part, which has chosen the "
           "kernel's width and ridge, too. The paper's {} % is "
           "an accuracy over all three parts, in one run, on 900 models of three classes of "
           "which other collections are at best a part; it states none for the test part. The "
           "nearest neighbour of a model is the nearest one of the training part but itself.",
           percent(paper_accuracy))}}};
}

Section run_section(std::span<const MethodScores> methods) {
  BarChart chart{.caption = "Accuracy on the test part, by run",
                 .y_label = "per cent right",
                 .categories = {},
                 .bands = {},
                 .series = {}};
  for (std::size_t run = 0; run < methods.front().test.size(); ++run) {
    chart.categories.push_back(std::to_string(run + 1));
  }
  for (const MethodScores& method : methods) {
    BarSeries series{.name = method.name, .values = {}};
    for (const double share : method.test) series.values.push_back(100 * share);
    chart.series.push_back(std::move(series));
  }
  return {"Runs", {std::move(chart)}};
}

Section confusion_section(const ClassificationComparison& comparison,
                          std::span<const MethodScores> methods) {
  Section section{"Confusion matrices", {}};
  const std::size_t runs = comparison.runs.size();
  for (const std::size_t method : {paper_network, own_network, kernel, neighbour}) {
    const MethodScores& scores = methods[method];
    section.blocks.emplace_back(
        ConfusionMatrix{fmt::format("{}: test part, sum of {} runs", scores.name, runs),
                        comparison.classes, scores.test_counts});
    section.blocks.emplace_back(
        ConfusionMatrix{fmt::format("{}: all parts, sum of {} runs", scores.name, runs),
                        comparison.classes, scores.overall_counts});
  }
  return section;
}

// ---- Models that are classified wrongly ----

/// How often a model was in the test part, and what it was taken for.
struct TestRecord {
  std::size_t model = 0;
  std::size_t tests = 0;
  std::vector<std::size_t> predicted;  ///< how often, for each class

  std::size_t wrong(std::size_t label) const { return tests - predicted[label]; }
};

std::vector<TestRecord> find_wrong_models(const ClassificationComparison& comparison,
                                          const ClassificationMethod& method) {
  std::vector<TestRecord> records;
  for (std::size_t model = 0; model < comparison.models.size(); ++model) {
    TestRecord record{model, 0, std::vector<std::size_t>(comparison.classes.size(), 0)};
    for (std::size_t run = 0; run < comparison.runs.size(); ++run) {
      if (comparison.runs[run].parts[model] != Part::test) continue;
      ++record.tests;
      ++record.predicted[method.predicted[run][model]];
    }
    if (record.wrong(comparison.labels[model]) > 0) records.push_back(std::move(record));
  }
  std::ranges::stable_sort(records, [&](const TestRecord& a, const TestRecord& b) {
    const std::size_t wrong_a = a.wrong(comparison.labels[a.model]);
    const std::size_t wrong_b = b.wrong(comparison.labels[b.model]);
    if (wrong_a != wrong_b) return wrong_a > wrong_b;
    return a.tests < b.tests;
  });
  return records;
}

Section wrong_model_section(const ClassificationComparison& comparison) {
  const ClassificationMethod& method = comparison.methods[own_network];
  const std::vector<TestRecord> records = find_wrong_models(comparison, method);
  const std::size_t listed = std::min(listed_models, records.size());
  Table table{.caption = fmt::format("The {} of {} models that were wrong most often by {}", listed,
                                     records.size(), method.name),
              .columns = {"model", "class", "tests", "wrong", "taken for"},
              .rows = {}};
  for (std::size_t i = 0; i < listed; ++i) {
    const TestRecord& record = records[i];
    const std::size_t label = comparison.labels[record.model];
    std::string taken_for;
    for (std::size_t other = 0; other < comparison.classes.size(); ++other) {
      if (other == label || record.predicted[other] == 0) continue;
      taken_for += (taken_for.empty() ? "" : ", ") + comparison.classes[other];
    }
    table.rows.push_back({comparison.models[record.model].name, comparison.classes[label],
                          std::to_string(record.tests), std::to_string(record.wrong(label)),
                          std::move(taken_for)});
  }
  return {"Models that are hard to tell", {std::move(table)}};
}

// ---- Numbers ----

ordered_json to_json(const Spread& spread) {
  return {{"mean", spread.mean},
          {"deviation", spread.deviation},
          {"lowest", spread.lowest},
          {"highest", spread.highest}};
}

ordered_json methods_to_json(const ClassificationComparison& comparison,
                             std::span<const MethodScores> methods) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const MethodScores& scores = methods[i];
    list.push_back({{"name", scores.name},
                    {"test", to_json(spread_of(scores.test))},
                    {"overall", to_json(spread_of(scores.overall))},
                    {"test_accuracy", scores.test},
                    {"overall_accuracy", scores.overall},
                    {"test_confusions", scores.test_counts},
                    {"overall_confusions", scores.overall_counts},
                    {"predicted", comparison.methods[i].predicted}});
  }
  return list;
}

ordered_json runs_to_json(const ClassificationComparison& comparison) {
  ordered_json list = ordered_json::array();
  for (const ClassificationRun& run : comparison.runs) {
    std::string parts;  // a letter for each model
    for (const Part part : run.parts) parts += "rvt"[static_cast<std::size_t>(part)];
    list.push_back({{"seed", run.seed}, {"parts", std::move(parts)}});
  }
  return list;
}

ordered_json to_json(const ClassificationComparison& comparison,
                     std::span<const MethodScores> methods, const Recipe& recipe,
                     const ClassifierOptions& network) {
  ordered_json models = ordered_json::array();
  for (std::size_t i = 0; i < comparison.models.size(); ++i) {
    models.push_back({{"name", comparison.models[i].name},
                      {"class", comparison.models[i].label},
                      {"label", comparison.labels[i]},
                      {"paper_features", comparison.paper_features[i]},
                      {comparison.signature, comparison.signatures[i]}});
  }
  return {{"paper_overall_accuracy", paper_accuracy},
          {"paper_feature_balls", comparison.paper_balls},
          {"signature", comparison.signature},
          {"signature_balls", comparison.signature_balls},
          {"similarity_distance",
           {{"radii", recipe.descriptor_balls}, {"walk_weight", recipe.walk_weight}}},
          {"network",
           {{"hidden_neurons", network.hidden_neurons},
            {"learning_rate", network.learning_rate},
            {"weight_decay", network.weight_decay},
            {"batch_size", network.batch_size},
            {"maximum_epochs", network.maximum_epochs},
            {"patience", network.patience}}},
          {"classes", comparison.classes},
          {"methods", methods_to_json(comparison, methods)},
          {"part_letters", {{"r", "training"}, {"v", "validation"}, {"t", "test"}}},
          {"runs", runs_to_json(comparison)},
          {"models", std::move(models)}};
}

// ---- In words ----

std::string summarise(const ClassificationComparison& comparison,
                      std::span<const MethodScores> methods) {
  const auto on_test = [&](std::size_t method) {
    return percent(spread_of(methods[method].test).mean);
  };
  return fmt::format(
      "On unknown models, the network is right for {} % with the paper's features and for {} % "
      "with {}, a kernel on the latter for {} %; the nearest neighbour for {} %, the largest class "
      "for {} % (test parts of {} runs). Over all three parts, as the paper counts, the network is "
      "right for {} % with the paper's features; the paper states {} %.",
      on_test(paper_network), on_test(own_network), comparison.signature, on_test(kernel),
      on_test(neighbour), on_test(neighbour + 1), comparison.runs.size(),
      percent(spread_of(methods[paper_network].overall).mean), percent(paper_accuracy));
}

std::vector<std::string> make_notes(const ClassificationComparison& comparison) {
  std::vector<std::string> notes;
  if (comparison.paper_balls != paper_balls) {
    notes.push_back(
        fmt::format("The paper's features are computed from {} balls; the paper has {}.",
                    comparison.paper_balls, paper_balls));
  }
  std::vector<std::size_t> sizes(comparison.classes.size(), 0);
  for (const std::size_t label : comparison.labels) ++sizes[label];
  const auto alone = std::ranges::count(sizes, 1U);
  if (alone > 0) {
    notes.push_back(counted(alone, "class", "es") +
                    " of one model cannot be learnt and tested; their models are counted all the "
                    "same.");
  }
  return notes;
}

}  // namespace

Report make_classify_report(const EvaluationInput& input, const ClassifyOptions& options) {
  const ClassificationComparison comparison = compare_classifiers(input, options);
  std::vector<MethodScores> methods;
  for (const ClassificationMethod& method : comparison.methods) {
    methods.push_back(score(comparison, method));
  }
  Report report;
  report.title = "Classification of " + input.collection.folder.filename().string();
  report.summary = summarise(comparison, methods);
  report.notes = make_notes(comparison);
  report.sections = {accuracy_section(comparison, methods), run_section(methods),
                     confusion_section(comparison, methods), wrong_model_section(comparison)};
  report.data = to_json(comparison, methods, input.cache.recipe(), options.network);
  return report;
}

}  // namespace mdbd
