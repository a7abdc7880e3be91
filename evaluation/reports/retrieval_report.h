#pragma once

#include <cstddef>

#include "evaluation/evaluation_input.h"
#include "report/report.h"

namespace mdbd {

struct RetrievalOptions {
  bool has_rivals = true;       ///< ESF, GASD, D2, harmonics of distances
  std::size_t confusions = 20;  ///< how many queries that went wrong are listed
};

/// Tells how well mdbd-100 and mdbd-fused find the models of a query's class, beside the rivals:
/// the measures of the Princeton Shape Benchmark (measures/retrieval_measures.h), over all queries
/// and for each class, precision against recall, pictures of the distances, and the worst
/// confusions. Report::data has every measure and, for each model, every vector, so that the
/// measures can be computed again from it.
/// @throws as ModelCache::describe, and InvalidInput if no class has two models to compare
Report make_retrieval_report(const EvaluationInput& input, const RetrievalOptions& options);

}  // namespace mdbd
