#pragma once

#include <chrono>
#include <functional>
#include <span>
#include <string>

#include "indexer/indexer.h"

namespace mdbd {

/// Hears what a watch does, beside what its runs do.
class WatchObserver : public IndexObserver {
 public:
  virtual void on_first_run_done(const IndexSummary& summary) = 0;
  /// Not every change is heard of, and why; empty: every one is. Told when it changes.
  virtual void on_limit(const std::string& limit) = 0;
};

struct WatchOptions {
  /// How often everything is looked at while not every change is heard of.
  std::chrono::duration<double> rescan = std::chrono::minutes(1);
  std::function<bool()> is_ended;  ///< asked a few times a second
};

/// Brings a store up to date with run_index() and keeps it so until that is ended: what changes is
/// looked at once it is quiet for half a second, or after five, and only that. What happens during
/// a run is looked at after it. A root that is not there is waited for; its models are not gone.
/// @param roots absolute and lexically normal
/// @throws IoError, StoreError as run_index()
void watch_index(std::span<const std::string> roots, IndexOptions options,
                 const DescribeFunction& describe, ShapeStore& store, WatchObserver& observer,
                 const WatchOptions& watching);

}  // namespace mdbd
