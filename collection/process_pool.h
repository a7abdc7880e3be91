#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace mdbd {

/// What a process of the pool may use.
struct ProcessLimits {
  std::chrono::duration<double> time{60.0};  ///< wall-clock time of one job
  /// Bytes of address space beyond what this program has when the job starts. Not enforced in
  /// builds with AddressSanitizer, which reserves terabytes.
  std::uint64_t memory = std::uint64_t{2} << 30;
};

/// How a job ended.
enum class ProcessEnd { finished, out_of_time, out_of_memory, died };

/// A job that has ended.
struct ProcessOutcome {
  std::size_t job = 0;
  ProcessEnd end = ProcessEnd::finished;
  std::string output;  ///< everything that the job sent before it ended
  std::string reason;  ///< for people, if it did not finish
  double seconds = 0.0;
};

/// Sends bytes from a job to the pool.
using SendOutput = std::function<void(std::string_view)>;

/// A job: runs in a process of its own and sees a copy of everything that existed when it started.
/// It must let std::bad_alloc pass and no other exception.
using ProcessWork = std::function<void(const SendOutput&)>;

/// Runs jobs in processes of their own, one each, so that a crash, a hang or a memory bomb costs
/// one job and not the program. A job has no open files but the way to its pool, its standard
/// streams lead nowhere, it does not hear SIGINT and SIGTERM, and it does not outlive the program.
/// The program must not have other threads. Not thread-safe.
class ProcessPool {
 public:
  ProcessPool(std::size_t processes, const ProcessLimits& limits);
  ~ProcessPool();  ///< kills the jobs that still run
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;

  bool is_full() const;
  bool is_empty() const;

  /// Starts a job under a number of the caller's choice.
  /// @pre !is_full()
  /// @throws std::system_error if the system gives no process: no fault of a file
  void start(std::size_t job, const ProcessWork& work);

  /// Waits until something happens, a signal arrives or the time is over.
  /// @returns the jobs that ended, often none
  std::vector<ProcessOutcome> wait(std::chrono::milliseconds at_most);

 private:
  struct Process;

  std::size_t capacity_;
  ProcessLimits limits_;
  std::vector<std::unique_ptr<Process>> processes_;
};

}  // namespace mdbd
