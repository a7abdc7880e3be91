#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "evaluation/evaluation_input.h"
#include "report/report.h"

namespace mdbd {

struct NoiseOptions {
  /// Lengths that no displacement of a vertex exceeds, in percent of the diameter of the smallest
  /// ball around the model; each from 0 to 100.
  std::vector<double> levels = {0.5, 1.0};
  /// The names of the models whose distances to all others are drawn, clean beside noisy; empty:
  /// the first model of each of four classes, or of all if there are fewer.
  std::vector<std::string> queries;
  std::size_t worst = 20;  ///< how many of the models that moved the furthest are listed
};

/// Tells how far noise on the surface changes the answers (paper, section 5.2, Figures 12 and 13):
/// every vertex of every model is displaced at random, and the noisy model is queried against the
/// clean collection. The measures are those of measures/robustness.h. Report::data has, beside
/// them, every descriptor, clean and noisy, so that they can be computed again from it.
/// @throws as ModelCache::describe, and InvalidInput if there is no level, a level is out of its
///         range or a query is no model of the collection that could be described
Report make_noise_report(const EvaluationInput& input, const NoiseOptions& options);

}  // namespace mdbd
