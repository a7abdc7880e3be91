#include "cli/interruption.h"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <initializer_list>

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

}  // namespace

void catch_interruptions() {
  struct sigaction action {};
  action.sa_handler = handle_signal;  // without SA_RESTART, so that waiting ends at once
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

bool is_interruption_wanted() { return first_signal != 0; }

}  // namespace mdbd
