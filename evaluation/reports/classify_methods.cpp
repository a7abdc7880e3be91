#include "evaluation/reports/classify_methods.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "evaluation/classifier/kernel_classifier.h"
#include "evaluation/classifier/paper_features.h"
#include "features/core/errors.h"
#include "features/core/random.h"

using nlohmann::ordered_json;

namespace mdbd {
namespace {

using Rows = std::vector<std::vector<double>>;
using Predictions = std::vector<std::vector<std::size_t>>;

// So few models have one in the validation part and one in the test part.
constexpr std::size_t least_models = 7;

void require_usable(const EvaluationInput& input, const ClassifyOptions& options) {
  if (options.runs < 1) throw InvalidInput("classify needs at least one run");
  const int needed = PaperFeatureOptions{}.radii;
  if (input.cache.recipe().balls < needed) {
    throw InvalidInput(fmt::format("classify needs at least {} balls a model; the recipe has {}",
                                   needed, input.cache.recipe().balls));
  }
}

/// The signature as a decomposition of no more balls would have it: the first balls do not depend
/// on how many follow.
void recompute_signatures(CleanModels& clean, const EvaluationInput& input, int balls) {
  for (DescribedModel& model : clean.descriptions) {
    const std::span<const Ball> all(model.balls);
    model.descriptor = signature_of(all.first(std::min<std::size_t>(balls, all.size())),
                                    model.scale, input.signature, input.cache.recipe());
  }
}

ClassificationComparison gather_models(const CleanModels& clean, const Recipe& recipe) {
  ClassificationComparison comparison;
  comparison.models = clean.models;
  for (const LabelledModel& model : clean.models) {
    std::vector<std::string>& classes = comparison.classes;
    if (classes.empty() || classes.back() != model.label) classes.push_back(model.label);
    comparison.labels.push_back(classes.size() - 1);
  }
  if (comparison.classes.size() < 2) {
    throw InvalidInput(fmt::format("classify needs models of two classes; all are of the class {}",
                                   comparison.classes.front()));
  }
  if (clean.models.size() < least_models) {
    throw InvalidInput(fmt::format("classify needs at least {} models; there are {}", least_models,
                                   clean.models.size()));
  }
  const PaperFeatureOptions options{.walk_damping = recipe.walk_damping,
                                    .contact_tolerance = recipe.contact_tolerance};
  for (const DescribedModel& model : clean.descriptions) {
    comparison.paper_features.push_back(paper_features(model.balls, model.scale, options));
    comparison.signatures.push_back(model.descriptor);
  }
  return comparison;
}

// ---- Networks ----

LabelledRows rows_of(const ClassificationComparison& comparison, const Rows& features,
                     std::span<const Part> parts, Part part) {
  LabelledRows rows;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] != part) continue;
    rows.rows.push_back(features[i]);
    rows.labels.push_back(comparison.labels[i]);
  }
  return rows;
}

std::vector<std::size_t> train_and_predict(const ClassificationComparison& comparison,
                                           const Rows& features, const ClassificationRun& run,
                                           const ClassifierOptions& options) {
  const Classifier classifier =
      train_classifier(rows_of(comparison, features, run.parts, Part::training),
                       rows_of(comparison, features, run.parts, Part::validation),
                       comparison.classes.size(), options, run.seed);
  return classifier.predict(features);
}

/// One training for each set of features and run, in processes.
std::vector<Predictions> run_networks(const EvaluationInput& input, const ClassifyOptions& options,
                                      const ClassificationComparison& comparison,
                                      std::span<const std::string> names,
                                      std::span<const Rows> features) {
  const std::size_t runs = comparison.runs.size();
  std::vector<std::string> pieces;
  for (const std::string& name : names) {
    for (std::size_t run = 0; run < runs; ++run) {
      pieces.push_back(fmt::format("{}, run {}", name, run + 1));
    }
  }
  const auto train = [&](std::size_t piece) {
    const std::vector<std::size_t> predicted = train_and_predict(
        comparison, features[piece / runs], comparison.runs[piece % runs], options.network);
    const std::vector<std::uint8_t> bytes = ordered_json::to_cbor(predicted);
    return std::string(bytes.begin(), bytes.end());
  };
  const auto results = input.cache.run("training", pieces, train);
  std::vector<Predictions> predictions(features.size());
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    if (!results[piece]) {
      throw InvalidInput(fmt::format("{}: the training failed: {}", pieces[piece],
                                     input.cache.failures().back().reason));
    }
    predictions[piece / runs].push_back(
        ordered_json::from_cbor(*results[piece]).get<std::vector<std::size_t>>());
  }
  return predictions;
}

// ---- Without networks ----

ClassificationMethod predict_by_kernel(const ClassificationComparison& comparison,
                                       const Rows& signatures) {
  ClassificationMethod method{"kernel, " + comparison.signature, {}};
  for (const ClassificationRun& run : comparison.runs) {
    method.predicted.push_back(
        classify_by_kernel(rows_of(comparison, signatures, run.parts, Part::training),
                           rows_of(comparison, signatures, run.parts, Part::validation),
                           comparison.classes.size(), signatures));
  }
  return method;
}

/// Every model gets the class of the nearest model of the training part but itself.
std::vector<std::size_t> predict_by_neighbour(const ClassificationComparison& comparison,
                                              const DistanceMatrix& distances,
                                              std::span<const Part> parts) {
  std::vector<std::size_t> predicted;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t label = 0;
    for (std::size_t j = 0; j < parts.size(); ++j) {
      if (j == i || parts[j] != Part::training || !(distances(i, j) < nearest)) continue;
      nearest = distances(i, j);
      label = comparison.labels[j];
    }
    predicted.push_back(label);
  }
  return predicted;
}

std::vector<std::size_t> predict_largest_class(const ClassificationComparison& comparison,
                                               std::span<const Part> parts) {
  std::vector<std::size_t> counts(comparison.classes.size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] == Part::training) ++counts[comparison.labels[i]];
  }
  const auto largest = std::ranges::max_element(counts);
  return std::vector<std::size_t>(parts.size(), largest - counts.begin());
}

}  // namespace

ClassificationComparison compare_classifiers(const EvaluationInput& input,
                                             const ClassifyOptions& options) {
  require_usable(input, options);
  const Recipe& recipe = input.cache.recipe();
  const int signature_balls = std::min(Recipe{}.balls, recipe.balls);
  CleanModels clean = describe_clean_models(input);
  recompute_signatures(clean, input, signature_balls);
  ClassificationComparison comparison = gather_models(clean, recipe);
  comparison.paper_balls = recipe.balls;
  comparison.signature_balls = signature_balls;
  comparison.signature = std::string(to_string(input.signature));
  for (int i = 0; i < options.runs; ++i) {
    const std::uint64_t seed = derive_seed(input.seed, fmt::format("classify, run {}", i + 1));
    comparison.runs.push_back({seed, split_at_random(clean.models.size(), seed)});
  }

  Rows signatures;
  for (const std::vector<float>& values : comparison.signatures) {
    signatures.emplace_back(values.begin(), values.end());
  }
  const std::vector<std::string> names{
      fmt::format("network, paper's {} features", comparison.paper_features.front().size()),
      "network, " + comparison.signature};
  const std::vector<Rows> features{comparison.paper_features, signatures};
  std::vector<Predictions> predictions = run_networks(input, options, comparison, names, features);
  for (std::size_t i = 0; i < names.size(); ++i) {
    comparison.methods.push_back({names[i], std::move(predictions[i])});
  }
  comparison.methods.push_back(predict_by_kernel(comparison, signatures));
  const DistanceMatrix distances = signature_matrix(input, clean);
  ClassificationMethod neighbour{"nearest neighbour, " + comparison.signature, {}};
  ClassificationMethod largest{"largest class", {}};
  for (const ClassificationRun& run : comparison.runs) {
    neighbour.predicted.push_back(predict_by_neighbour(comparison, distances, run.parts));
    largest.predicted.push_back(predict_largest_class(comparison, run.parts));
  }
  comparison.methods.push_back(std::move(neighbour));
  comparison.methods.push_back(std::move(largest));
  return comparison;
}

}  // namespace mdbd
