#pragma once

#include <ctime>

namespace mdbd::bench {

/// The processor time of this process since it began, all threads, user and system, in seconds.
inline double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace mdbd::bench
