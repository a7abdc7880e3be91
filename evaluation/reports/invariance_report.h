#pragma once

#include <cstddef>

#include "evaluation/evaluation_input.h"
#include "report/report.h"

namespace mdbd {

struct InvarianceOptions {
  std::size_t worst = 20;  ///< how many of the models that moved the furthest are listed
};

/// Tells how far the answers change under what should not change them: a random rotation,
/// translation, scale and reflection, the way through a file of another format, subdivision,
/// decimation to 50 % and 10 % of the faces, another order of vertices and faces. Every changed
/// model is queried against the collection as it is. The measures are those of
/// measures/robustness.h. Report::data has, beside them, every descriptor, so that they can be
/// computed again from it.
/// @throws as ModelCache::describe
Report make_invariance_report(const EvaluationInput& input, const InvarianceOptions& options);

}  // namespace mdbd
