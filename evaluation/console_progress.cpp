#include "evaluation/console_progress.h"

#include <fmt/format.h>

#include "cli/interruption.h"
#include "cli/program.h"
#include "cli/terminal.h"

namespace mdbd {

ConsoleProgress::ConsoleProgress(std::string program, bool is_quiet)
    : program_(std::move(program)), is_quiet_(is_quiet), bar_(stderr, !is_quiet) {
  catch_interruptions();
}

void ConsoleProgress::on_stage(const std::string& stage, std::size_t models) {
  if (is_quiet_) return;
  bar_.erase();
  bar_.print_above(fmt::format("{}: {} to compute", printable(stage), models));
  bar_.start(models);
}

void ConsoleProgress::on_model_done(bool has_failed) { bar_.advance(has_failed); }

void ConsoleProgress::on_failure(std::string_view stage, std::string_view model,
                                 std::string_view reason) {
  if (is_quiet_) return;
  bar_.erase();
  print_warning(program_, fmt::format("{}{}{}: {}", printable(stage), stage.empty() ? "" : ": ",
                                      printable(model), printable(reason)));
  bar_.refresh();
}

void ConsoleProgress::on_wait() { bar_.refresh(); }

void ConsoleProgress::finish() { bar_.erase(); }

bool ConsoleProgress::is_interrupted() {
  if (!is_interruption_wanted()) return false;
  if (!has_announced_end_ && !is_quiet_) {
    bar_.print_above("Finishing the models in flight; once more to stop at once.");
    has_announced_end_ = true;
  }
  return true;
}

}  // namespace mdbd
