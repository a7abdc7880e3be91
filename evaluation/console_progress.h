#pragma once

#include <string>

#include "cli/run_console.h"
#include "evaluation/progress.h"

namespace mdbd {

/// Shows an evaluation on a console.
class ConsoleProgress final : public EvaluationProgress {
 public:
  /// @param console must outlive this object
  explicit ConsoleProgress(RunConsole& console) : console_(console) {}

  void on_stage(const std::string& stage, std::size_t models) override;
  void on_model_done(bool has_failed) override { console_.advance(has_failed); }
  void on_failure(std::string_view stage, std::string_view model, std::string_view reason) override;
  void on_wait() override { console_.refresh(); }
  bool is_interrupted() override { return console_.is_interrupted(); }

 private:
  RunConsole& console_;
};

}  // namespace mdbd
