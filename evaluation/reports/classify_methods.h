#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/classifier/classifier.h"
#include "evaluation/evaluation_input.h"
#include "evaluation/measures/classification.h"

namespace mdbd {

struct ClassifyOptions {
  int runs = 10;  ///< random divisions of the models, each with a training of its own
  ClassifierOptions network;
};

/// One random division of the models.
struct ClassificationRun {
  std::uint64_t seed = 0;  ///< of the division and of the training
  std::vector<Part> parts;
};

/// A way of telling the class of a model, learnt from the training part of a run.
struct ClassificationMethod {
  std::string name;
  std::vector<std::vector<std::size_t>> predicted;  ///< for each run, of all models
};

/// Methods side by side on the same divisions of the same models.
struct ClassificationComparison {
  std::vector<LabelledModel> models;  ///< ordered by class, then by name
  std::vector<std::string> classes;
  std::vector<std::size_t> labels;  ///< of the models: indices into classes
  std::vector<std::vector<double>> paper_features;
  std::string signature;  ///< the name of the one that is measured
  std::vector<std::vector<float>> signatures;
  int paper_balls = 0;      ///< from how many balls the paper's features are
  int signature_balls = 0;  ///< from how many the signature is
  std::vector<ClassificationRun> runs;
  /// The network on the paper's features, the network on the signature, least squares by a kernel
  /// on the signature, the nearest neighbour by the signature's distance, the largest class.
  std::vector<ClassificationMethod> methods;
};

/// Trains and predicts. The signature is computed from as many balls as a recipe has by default,
/// however many there are.
/// @throws as ModelCache::describe and ModelCache::run, and InvalidInput if the recipe has fewer
///         balls than the features need, there are fewer than two classes or seven models, `runs`
///         is not positive, or a training failed
ClassificationComparison compare_classifiers(const EvaluationInput& input,
                                             const ClassifyOptions& options);

}  // namespace mdbd
