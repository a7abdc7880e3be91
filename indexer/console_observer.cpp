#include "indexer/console_observer.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <initializer_list>

#include "cli/program.h"
#include "cli/terminal.h"

namespace mdbd {
namespace {

/// When the first signal came, in milliseconds of the monotonic clock; 0 before.
std::atomic<std::int64_t> first_signal = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

/// A wish to stop at once comes some time after the first signal; "timeout", for one, sends each
/// signal twice.
constexpr std::int64_t patience = 500;

void handle_signal(int signal) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t time = now.tv_sec * std::int64_t{1000} + now.tv_nsec / 1'000'000;
  if (first_signal == 0) {
    first_signal = time;
  } else if (time - first_signal > patience) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

/// Without SA_RESTART, so that waiting ends at once.
void catch_signals() {
  struct sigaction action {};
  action.sa_handler = handle_signal;
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
  if (first_signal != 0 && !has_announced_end_ && !is_quiet_) {
    bar_.print_above("Finishing the models in flight; once more to stop at once.");
    has_announced_end_ = true;
  }
  return first_signal != 0;
}

}  // namespace mdbd
