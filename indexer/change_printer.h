#pragma once

#include <string>
#include <unordered_set>

#include "indexer/console_observer.h"
#include "indexer/watch_index.h"

namespace mdbd {

/// Shows a watch: the first run with a progress bar on standard error, then a line on standard
/// output for each change.
class ChangePrinter final : public WatchObserver {
 public:
  /// @param console must outlive this object
  ChangePrinter(RunConsole& console, bool is_quiet)
      : console_(console), observer_(console), is_quiet_(is_quiet) {}

  void on_start(std::size_t models) override;
  void on_more_models(std::size_t models) override;
  void on_model_done(bool has_failed) override;
  void on_failure(const IndexFailure& failure) override;
  void on_change(const IndexChange& change) override;
  void on_wait() override { observer_.on_wait(); }
  bool is_interrupted() override { return observer_.is_interrupted(); }
  void on_first_run_done(const IndexSummary& summary) override;
  void on_limit(const std::string& limit) override;

 private:
  RunConsole& console_;
  ConsoleObserver observer_;
  bool is_quiet_;
  bool is_first_run_ = true;
  std::unordered_set<std::string> gone_;  ///< paths that were said to be gone
};

}  // namespace mdbd
