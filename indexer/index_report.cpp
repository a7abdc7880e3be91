#include "indexer/index_report.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "cli/terminal.h"

namespace mdbd {
namespace {

constexpr std::size_t failures_listed = 10;

}  // namespace

std::string format_index_json(const IndexSummary& summary, const std::filesystem::path& database,
                              bool is_dry_run) {
  using nlohmann::ordered_json;
  ordered_json failures = ordered_json::array();
  for (const IndexFailure& failure : summary.failures) {
    failures.push_back({{"path", failure.path}, {"reason", failure.reason}});
  }
  const ordered_json object = {{"indexed", summary.indexed},
                               {"unchanged", summary.unchanged},
                               {"moved", summary.moved},
                               {"failed", summary.failures.size()},
                               {"removed", summary.removed},
                               {"gone", summary.gone},
                               {"completed", summary.completed},
                               {"left", summary.left},
                               {"interrupted", summary.is_interrupted},
                               {"dry_run", is_dry_run},
                               {"seconds", summary.seconds},
                               {"database", database.string()},
                               {"failures", std::move(failures)}};
  return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string format_index_text(const IndexSummary& summary, const std::filesystem::path& database,
                              bool is_dry_run) {
  std::string text;
  const auto add = [&](const char* name, std::size_t count, bool always, const char* note = "") {
    if (count > 0 || always) text += fmt::format("{:<10}{:>8}{}\n", name, count, note);
  };
  add(is_dry_run ? "to index" : "indexed", summary.indexed, true);
  add("unchanged", summary.unchanged, true);
  add("moved", summary.moved, false);
  add("failed", summary.failures.size(), true);
  add(is_dry_run ? "to remove" : "removed", summary.removed, false);
  add("gone", summary.gone, false, "  (kept; --prune removes them)");
  add("completed", summary.completed, false, "  (mdbd-fused computed from stored balls)");
  text += is_dry_run ? fmt::format("Nothing was written to {}", printable(database.string()))
                     : fmt::format("Database {}", printable(database.string()));
  return text +
         fmt::format(", {}\n", format_duration(std::chrono::duration<double>(summary.seconds)));
}

std::string format_old_failures(const IndexSummary& summary) {
  std::vector<const IndexFailure*> old;
  for (const IndexFailure& failure : summary.failures) {
    if (failure.is_old) old.push_back(&failure);
  }
  if (old.empty()) return "";
  std::string text = "Failed in an earlier run and unchanged since (--force tries again):\n";
  const std::size_t listed = std::min(old.size(), failures_listed);
  for (std::size_t i = 0; i < listed; ++i) {
    text += fmt::format("  {}: {}\n", printable(old[i]->path), printable(old[i]->reason));
  }
  if (listed < old.size()) text += fmt::format("  and {} more; see --json\n", old.size() - listed);
  return text;
}

}  // namespace mdbd
