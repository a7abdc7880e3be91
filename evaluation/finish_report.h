#pragma once

#include <span>
#include <string>

#include "evaluation/evaluation_input.h"
#include "report/report.h"

namespace mdbd {

/// A command line as it could be typed again: words that a shell would change are quoted.
std::string join_command(std::span<const char* const> words);

/// What produced a report, as far as the report cannot know it.
struct ReportOrigin {
  std::string command;
  std::string version;  ///< of the program
};

/// Completes a report: its provenance; notes on the collection and on models that failed, before
/// its own; a table of those models; and in its data "collection" and "failures".
void finish_report(Report& report, const EvaluationInput& input, const ReportOrigin& origin);

/// Whether a model or a path of the collection could not be used.
bool has_failures(const EvaluationInput& input);

}  // namespace mdbd
