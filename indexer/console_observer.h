#pragma once

#include "cli/run_console.h"
#include "indexer/indexer.h"

namespace mdbd {

/// Shows an index run on a console.
class ConsoleObserver final : public IndexObserver {
 public:
  /// @param console must outlive this object
  explicit ConsoleObserver(RunConsole& console) : console_(console) {}

  void on_start(std::size_t models) override { console_.start(models); }
  void on_more_models(std::size_t models) override { console_.extend(models); }
  void on_model_done(bool has_failed) override { console_.advance(has_failed); }
  void on_failure(const IndexFailure& failure) override;
  void on_wait() override { console_.refresh(); }
  bool is_interrupted() override { return console_.is_interrupted(); }

 private:
  RunConsole& console_;
};

}  // namespace mdbd
