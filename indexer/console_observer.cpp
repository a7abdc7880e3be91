#include "indexer/console_observer.h"

#include "cli/interruption.h"
#include "cli/program.h"
#include "cli/terminal.h"

namespace mdbd {

ConsoleObserver::ConsoleObserver(std::string program, bool is_quiet)
    : program_(std::move(program)), is_quiet_(is_quiet), bar_(stderr, !is_quiet) {
  catch_interruptions();
}

void ConsoleObserver::on_start(std::size_t models) { bar_.start(models); }

void ConsoleObserver::on_model_done(bool has_failed) { bar_.advance(has_failed); }

void ConsoleObserver::on_failure(const IndexFailure& failure) {
  if (is_quiet_) return;
  bar_.erase();
  print_warning(program_, printable(failure.path) + ": " + printable(failure.reason));
  bar_.refresh();
}

void ConsoleObserver::on_wait() { bar_.refresh(); }

void ConsoleObserver::finish() { bar_.erase(); }

bool ConsoleObserver::is_interrupted() {
  if (!is_interruption_wanted()) return false;
  if (!has_announced_end_ && !is_quiet_) {
    bar_.print_above("Finishing the models in flight; once more to stop at once.");
    has_announced_end_ = true;
  }
  return true;
}

}  // namespace mdbd
