#pragma once

#include <string>

#include "cli/progress_bar.h"
#include "evaluation/progress.h"

namespace mdbd {

/// Shows an evaluation on standard error, and ends it at SIGINT or SIGTERM; a second one, half a
/// second later or more, has its default effect. Only one may exist.
class ConsoleProgress final : public EvaluationProgress {
 public:
  /// @param program its name, for messages
  ConsoleProgress(std::string program, bool is_quiet);

  void on_stage(const std::string& stage, std::size_t models) override;
  void on_model_done(bool has_failed) override;
  void on_failure(std::string_view stage, std::string_view model, std::string_view reason) override;
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
