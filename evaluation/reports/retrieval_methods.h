#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluation_input.h"
#include "evaluation/measures/retrieval_measures.h"
#include "evaluation/measures/vector_distance.h"

namespace mdbd {

/// The vectors of all models under one signature.
struct ComparedSignature {
  std::string name;
  std::vector<std::vector<float>> vectors;
};

/// A way of ordering models by similarity: a distance between the vectors of a signature.
struct RetrievalMethod {
  std::string name;       ///< "mdbd-100", "radii alone", "ESF"
  std::string signature;  ///< the name of a ComparedSignature
  bool is_rival = false;
  std::vector<DistanceTerm> terms;
  DistanceMatrix distances;
  RetrievalMeasures measures;
};

/// Methods side by side on the same models.
struct RetrievalComparison {
  std::vector<LabelledModel> models;  ///< ordered by class, then by name
  std::vector<ComparedSignature> signatures;
  /// mdbd-100, its two parts, mdbd-fused, then the rivals.
  std::vector<RetrievalMethod> methods;
  std::size_t measured = 0;  ///< the method of the signature that the report is about
  std::size_t left_out = 0;  ///< models that were described but that a rival failed on
};

/// Measures mdbd-100 and its parts, the radii alone and the walk alone, mdbd-fused, and beside them
/// the rivals ESF, GASD, D2 and harmonics of the distance transform on the models that all can
/// describe.
/// @throws as ModelCache::describe, and InvalidInput if no class has two such models
RetrievalComparison compare_retrieval(const EvaluationInput& input, bool has_rivals);

}  // namespace mdbd
