#pragma once

#include <filesystem>
#include <string>

#include "query/duplicates.h"

namespace mdbd {

/// Groups for people: of each the model to keep and, below, each other one with what it is beside
/// that: its distance, its size ("x 25.4"), its hand, and whether the files are the same. Paths are
/// shown as by format_table() of queries. Empty if there are no groups.
std::string format_duplicates_table(const DuplicateReport& report,
                                    const std::filesystem::path& directory);

/// {"compared", "threshold", "groups": [{"keep": id, "models": [{"id", "path", "format", "scale",
/// "file_size"}], "pairs": [{"first": id, "second": id, "distance", "radii_distance",
/// "scale_ratio", "hand", "same_bytes"}]}]}, with a line end.
std::string format_duplicates_json(const DuplicateReport& report, double threshold);

/// A line of CSV for each pair, below a header line.
std::string format_duplicates_csv(const DuplicateReport& report);

}  // namespace mdbd
