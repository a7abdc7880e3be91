#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "evaluation/progress.h"

namespace mdbd::test {

/// Notes what it hears, and ends the evaluation after so many models.
class RecordingProgress final : public EvaluationProgress {
 public:
  void on_stage(const std::string& stage, std::size_t models) override {
    stages.push_back(stage + ": " + std::to_string(models));
  }
  void on_model_done(bool has_failed) override {
    ++done;
    failed += has_failed ? 1 : 0;
  }
  void on_failure(std::string_view stage, std::string_view model,
                  std::string_view reason) override {
    failures.push_back(std::string(stage) + '|' + std::string(model) + '|' + std::string(reason));
  }
  void on_wait() override {}
  bool is_interrupted() override { return done >= interrupt_after; }

  std::vector<std::string> stages;
  std::vector<std::string> failures;
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t interrupt_after = 1000;
};

}  // namespace mdbd::test
