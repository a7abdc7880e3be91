#pragma once

#include "evaluation/evaluation_input.h"
#include "evaluation/reports/classify_methods.h"
#include "report/report.h"

namespace mdbd {

/// Tells how well a small neural network learns the classes (paper, section 5.3): from the 130
/// features of the paper and from mdbd-100, over several random divisions into 70 % training, 15 %
/// validation and 15 % test; beside the nearest neighbour by the similarity distance and the
/// largest class. The accuracy on the test part is kept apart from that over all parts, which is
/// what the paper states. The recipe of the cache says how many balls the paper's features come
/// from; the paper has 800. Report::data has the features of each model, the divisions and all
/// predictions, so that every number can be computed again from it.
/// @throws as compare_classifiers
Report make_classify_report(const EvaluationInput& input, const ClassifyOptions& options);

}  // namespace mdbd
