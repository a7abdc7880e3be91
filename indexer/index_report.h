#pragma once

#include <filesystem>
#include <string>

#include "indexer/indexer.h"

namespace mdbd {

/// A summary as one JSON object: {indexed, unchanged, moved, failed, removed, gone, left,
/// interrupted, dry_run, seconds, database, failures: [{path, reason}]}. Bytes of paths that are no
/// UTF-8 become U+FFFD.
std::string format_index_json(const IndexSummary& summary, const std::filesystem::path& database,
                              bool is_dry_run);

/// A summary for people, a few lines.
std::string format_index_text(const IndexSummary& summary, const std::filesystem::path& database,
                              bool is_dry_run);

/// The failures known from earlier runs for people, the first few of them; empty if there are none.
std::string format_old_failures(const IndexSummary& summary);

}  // namespace mdbd
