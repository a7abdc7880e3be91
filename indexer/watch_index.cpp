#include "indexer/watch_index.h"

#include <filesystem>
#include <optional>
#include <vector>

#include "collection/discover.h"
#include "indexer/folder_watch.h"

namespace mdbd {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds idle_interval{200};
constexpr std::chrono::milliseconds quiet_interval{500};
constexpr std::chrono::seconds longest_delay{5};

void add(FolderChanges more, FolderChanges& changes) {
  changes.paths.merge(more.paths);
  changes.is_everything = changes.is_everything || more.is_everything;
}

/// Waits until something has changed and it is quiet, everything has to be looked at, or the end.
FolderChanges wait_for_changes(FolderWatch& watch, const WatchOptions& options) {
  const Clock::time_point start = Clock::now();
  std::optional<Clock::time_point> first;
  FolderChanges changes;
  while (!options.is_ended()) {
    const bool is_quiet = !watch.wait(changes.empty() ? idle_interval : quiet_interval);
    add(watch.take_changes(), changes);
    const Clock::time_point now = Clock::now();
    if (!changes.empty()) {
      if (!first) first = now;
      if (is_quiet || now - *first > longest_delay) break;
    } else if (!watch.limit().empty() && now - start > options.rescan) {
      watch.watch_again();
      changes.is_everything = true;
      break;
    }
  }
  return changes;
}

Discovery look_at(const FolderChanges& changes, std::span<const std::string> roots) {
  if (changes.is_everything) {
    return discover_existing(std::vector<std::filesystem::path>(roots.begin(), roots.end()));
  }
  return discover_changed(
      std::vector<std::filesystem::path>(changes.paths.begin(), changes.paths.end()));
}

}  // namespace

void watch_index(std::span<const std::string> roots, IndexOptions options,
                 const DescribeFunction& describe, ShapeStore& store, WatchObserver& observer,
                 const WatchOptions& watching) {
  FolderWatch watch(roots);
  std::string told_limit;
  const auto tell_limit = [&] {
    if (watch.limit() == told_limit) return;
    told_limit = watch.limit();
    observer.on_limit(told_limit);
  };
  FolderChanges changes{.paths = {}, .is_everything = true};
  bool is_first = true;
  while (true) {
    const IndexSummary summary =
        run_index(look_at(changes, roots), options, describe, store, observer);
    if (summary.is_interrupted) return;
    if (is_first) observer.on_first_run_done(summary);
    is_first = false;
    options.force = false;  // which was for what is there already
    tell_limit();
    changes = wait_for_changes(watch, watching);
    if (watching.is_ended()) return;
  }
}

}  // namespace mdbd
