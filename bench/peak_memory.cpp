#include "bench/peak_memory.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <malloc.h>

namespace mdbd::bench {
namespace {

// A line of /proc/self/status that counts kB.
std::uint64_t bytes_of(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == name && status >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

}  // namespace

PeakMemory::PeakMemory() {
  malloc_trim(0);  // what was freed before must not hide what is allocated now
  std::ofstream("/proc/self/clear_refs") << "5";  // forgets the peak, see proc(5)
  before_ = bytes_of("VmRSS:");
}

std::uint64_t PeakMemory::increase() const {
  return std::max(bytes_of("VmHWM:"), before_) - before_;
}

}  // namespace mdbd::bench
