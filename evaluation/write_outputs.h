#pragma once

#include <filesystem>

#include "report/report.h"

namespace mdbd {

/// Where a report is written to; an empty path is not written.
struct ReportOutputs {
  std::filesystem::path json;  ///< "-": standard output
  std::filesystem::path html;

  bool is_json_printed() const { return json == "-"; }
};

/// Finds out what can be known beforehand, so that no long computation ends in vain.
/// @throws IoError if an output is a folder, or its folder does not exist or is not writable
void require_writable(const ReportOutputs& outputs);

/// Writes the files, each as a whole or not at all; standard output is left to the caller.
/// @throws IoError
void write_outputs(const Report& report, const ReportOutputs& outputs);

}  // namespace mdbd
