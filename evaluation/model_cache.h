#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "collection/process_pool.h"
#include "evaluation/labelled_collection.h"
#include "evaluation/progress.h"
#include "features/core/recipe.h"
#include "features/shape.h"
#include "store/shape_store.h"

namespace mdbd {

/// The way from a model file to the shape that is described: as it is, or changed.
struct Variant {
  /// Names the change with all its parameters and seeds, for people and as a key of the cache:
  /// "noise 0.5 %, seed 1". Empty: the model as it is.
  std::string name;
  /// Loads the shape of a file for a recipe. It may depend on the variant's name and on the file's
  /// content and ending only, not on its path: copies of a file share their results.
  /// @throws IoError, InvalidInput
  std::function<Shape(const std::filesystem::path&, const Recipe&)> load;
};

/// The models as they are.
Variant clean_variant();

/// A further signature, computed from a file: a rival.
struct FileSignature {
  std::string name;  ///< names it with all its parameters and seeds; a key of the cache
  /// @throws IoError, InvalidInput
  std::function<std::vector<float>(const std::filesystem::path&)> compute;
};

/// What is known of one model under one variant.
struct DescribedModel {
  std::vector<Ball> balls;        ///< object units, in order of placement
  std::vector<float> descriptor;  ///< laid out as Descriptor::values
  double scale = 0.0;             ///< R in object units
  std::string statistics;         ///< a JSON object: what was read and what was done to it
};

/// For each model asked for, in its order; empty where it failed.
using DescribedModels = std::vector<std::optional<DescribedModel>>;
using SignatureVectors = std::vector<std::optional<std::vector<float>>>;

/// A model that could not be read, changed or described.
struct EvaluationFailure {
  std::string stage;  ///< the variant or signature; empty for the models as they are
  std::string model;  ///< LabelledModel::name
  std::string reason;
};

/// Thrown when the observer ends an evaluation. Everything computed so far is in the cache.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted; run the same command to continue") {}
};

struct CacheOptions {
  std::filesystem::path folder;  ///< of the databases, one for each recipe; created if missing
  std::size_t jobs = 1;          ///< models computed at the same time
  ProcessLimits limits = {};     ///< of one model
};

/// Descriptions of models and of changed copies of them, kept in a database: what is there and
/// whose file has the size and time of then is not computed again, nor is content that is known
/// from another file. Failures are kept, too; only files that could not be read are tried again.
/// Every model is computed in a process of its own, with a budget, and stored as soon as it is
/// done. Results do not depend on the number of jobs.
class ModelCache {
 public:
  /// @throws StoreError, IoError
  ModelCache(const CacheOptions& options, const Recipe& recipe, EvaluationProgress& progress);

  const Recipe& recipe() const { return recipe_; }

  /// Describes models under a variant.
  /// @throws Interrupted, StoreError, std::system_error if no process can be started
  DescribedModels describe(std::span<const LabelledModel> models, const Variant& variant);

  /// Computes a further signature of models; empty also for models that cannot be described as they
  /// are.
  /// @pre the models were described as they are; the signature has a name that describe() does not
  ///      use: not mdbd-100
  /// @throws as describe
  SignatureVectors compute_signature(std::span<const LabelledModel> models,
                                     const FileSignature& signature);

  /// Runs other work in the same way: a process for each piece, with budget and progress. Nothing
  /// of it is kept.
  /// @param names of the pieces, for messages
  /// @param work computes a piece. @throws IoError, InvalidInput
  /// @returns what `work` returned for each piece; empty where it failed
  /// @throws as describe
  std::vector<std::optional<std::string>> run(const std::string& stage,
                                              std::span<const std::string> names,
                                              const std::function<std::string(std::size_t)>& work);

  /// Every failure that was met, once, in the order of the calls and of the models.
  const std::vector<EvaluationFailure>& failures() const { return failures_; }

 private:
  void add_failure(EvaluationFailure failure);

  CacheOptions options_;
  Recipe recipe_;
  std::unique_ptr<ShapeStore> store_;
  EvaluationProgress& progress_;
  std::vector<EvaluationFailure> failures_;
};

}  // namespace mdbd
