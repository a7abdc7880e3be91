#pragma once

#include <cstdint>

namespace mdbd::bench {

/// How much more memory this process comes to use than when the object was made. Linux only.
class PeakMemory {
 public:
  PeakMemory();

  /// The largest increase of resident memory so far, in bytes; 0 where the system does not tell.
  std::uint64_t increase() const;

 private:
  std::uint64_t before_;
};

}  // namespace mdbd::bench
