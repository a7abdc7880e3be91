#pragma once

#include "cli/progress_bar.h"
#include "indexer/indexer.h"

namespace mdbd {

/// Shows a run on standard error, and ends it at SIGINT or SIGTERM; a second one, half a second
/// later or more, has its default effect. Only one may exist.
class ConsoleObserver final : public IndexObserver {
 public:
  /// @param program its name, for messages
  ConsoleObserver(std::string program, bool is_quiet);

  void on_start(std::size_t models) override;
  void on_model_done(bool has_failed) override;
  void on_failure(const IndexFailure& failure) override;
  void on_wait() override;
  bool is_interrupted() override;

  /// Takes the progress bar off the terminal.
  void finish();

 private:
  std::string program_;
  bool is_quiet_;
  bool has_announced_end_ = false;
  ProgressBar bar_;
};

}  // namespace mdbd
