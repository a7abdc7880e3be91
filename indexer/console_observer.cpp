#include "indexer/console_observer.h"

#include <csignal>
#include <initializer_list>

#include "cli/program.h"
#include "cli/terminal.h"

namespace mdbd {
namespace {

volatile std::sig_atomic_t signal_count = 0;

/// Without SA_RESTART, so that waiting ends at once.
void catch_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { signal_count = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

}  // namespace

ConsoleObserver::ConsoleObserver(std::string program, bool is_quiet)
    : program_(std::move(program)), is_quiet_(is_quiet), bar_(stderr, !is_quiet) {
  catch_signals();
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
  if (signal_count != 0 && !has_announced_end_ && !is_quiet_) {
    bar_.print_above("Finishing the models in flight; once more to stop at once.");
    has_announced_end_ = true;
  }
  return signal_count != 0;
}

}  // namespace mdbd
