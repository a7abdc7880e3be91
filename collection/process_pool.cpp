#include "collection/process_pool.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/options.h"

namespace mdbd {
namespace {

using Clock = std::chrono::steady_clock;

/// Exit codes of a job; a library that calls exit() is not likely to hit them.
constexpr int exit_finished = 90;
constexpr int exit_out_of_memory = 91;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool has_address_sanitizer = true;
#elif defined(__has_feature)
constexpr bool has_address_sanitizer = __has_feature(address_sanitizer);
#else
constexpr bool has_address_sanitizer = false;
#endif

[[noreturn]] void throw_system_error(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

// ---- In the new process ----

std::uint64_t address_space_in_use() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void limit_resource(int resource, rlim_t value) {
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_max = std::min(limit.rlim_max, value);
  limit.rlim_cur = std::min(limit.rlim_cur, limit.rlim_max);
  setrlimit(resource, &limit);
}

/// Leaves a job with its pipe as descriptor 3 and nothing else of the program's: a reader gone wild
/// must not reach the database. Reports of sanitizers still come through.
void detach(int pipe_end) {
  const int pipe = fcntl(pipe_end, F_DUPFD, 4);  // out of the way, even if 0, 1 and 2 were closed
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (stream != STDERR_FILENO || !has_address_sanitizer) dup2(nowhere, stream);
  }
  dup2(pipe, 3);
  close_range(4, ~0U, 0);
}

void become_job(int pipe_end, pid_t parent, const ProcessLimits& limits) {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it died before it could be watched
  detach(pipe_end);
  limit_resource(RLIMIT_CORE, 0);
  if (!has_address_sanitizer) {
    limit_resource(RLIMIT_AS, static_cast<rlim_t>(address_space_in_use() + limits.memory));
  }
}

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) _exit(1);
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

[[noreturn]] void run_job(const ProcessWork& work) noexcept {
  try {
    work([](std::string_view bytes) { write_all(3, bytes); });
  } catch (const std::bad_alloc&) {
    _exit(exit_out_of_memory);
  }
  _exit(exit_finished);
}

}  // namespace

// ---- In the program ----

struct ProcessPool::Process {
  std::size_t job = 0;
  pid_t id = -1;
  int pipe_end = -1;
  Clock::time_point started;
  Clock::time_point deadline;
  bool is_overdue = false;  ///< its time was over and it was killed
  std::string output;

  Process() = default;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  ~Process() {
    if (id > 0) {
      kill(id, SIGKILL);
      wait_for_exit();
    }
    close(pipe_end);
  }

  /// Reads what has arrived. @returns false at the end: the process is gone
  bool receive() {
    std::array<char, 65536> buffer;
    while (true) {
      const ssize_t size = read(pipe_end, buffer.data(), buffer.size());
      if (size > 0) output.append(buffer.data(), static_cast<std::size_t>(size));
      if (size == 0) return false;
      if (size < 0 && errno != EINTR) return true;
    }
  }

  int wait_for_exit() {
    int status = 0;
    while (waitpid(id, &status, 0) < 0 && errno == EINTR) continue;
    id = -1;
    return status;
  }

  ProcessOutcome finish(const ProcessLimits& limits) {
    const int status = wait_for_exit();
    ProcessOutcome outcome;
    outcome.job = job;
    outcome.output = std::move(output);
    outcome.seconds = std::chrono::duration<double>(Clock::now() - started).count();
    explain(outcome, status, limits);
    return outcome;
  }

 private:
  void explain(ProcessOutcome& outcome, int status, const ProcessLimits& limits) const {
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (code == exit_finished) return;
    if (is_overdue) {
      outcome.end = ProcessEnd::out_of_time;
      outcome.reason = fmt::format("took longer than the time budget of {} (--model-time)",
                                   format_duration(limits.time));
    } else if (code == exit_out_of_memory) {
      outcome.end = ProcessEnd::out_of_memory;
      outcome.reason = fmt::format("needs more than the memory budget of {} (--model-memory)",
                                   format_size(limits.memory));
    } else if (signal == SIGKILL) {
      outcome.end = ProcessEnd::out_of_memory;
      outcome.reason = "the system killed the process reading it, probably for want of memory";
    } else {
      outcome.end = ProcessEnd::died;
      outcome.reason = signal != 0 ? fmt::format("the process reading it died (signal {}, {})",
                                                 signal, strsignal(signal))
                                   : fmt::format("the process reading it ended with code {}", code);
    }
  }
};

ProcessPool::ProcessPool(std::size_t processes, const ProcessLimits& limits)
    : capacity_(processes), limits_(limits) {}

ProcessPool::~ProcessPool() = default;

bool ProcessPool::is_full() const { return processes_.size() >= capacity_; }

bool ProcessPool::is_empty() const { return processes_.empty(); }

void ProcessPool::start(std::size_t job, const ProcessWork& work) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw_system_error(errno, "cannot create a pipe");
  auto process = std::make_unique<Process>();
  process->job = job;
  process->pipe_end = ends[0];
  process->started = Clock::now();
  process->deadline = process->started + std::chrono::duration_cast<Clock::duration>(limits_.time);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    become_job(ends[1], parent, limits_);
    run_job(work);
  }
  const int error = errno;
  close(ends[1]);
  if (child < 0) throw_system_error(error, "cannot start a process");
  process->id = child;
  processes_.push_back(std::move(process));
}

std::vector<ProcessOutcome> ProcessPool::wait(std::chrono::milliseconds at_most) {
  auto until = Clock::now() + at_most;
  std::vector<pollfd> polled;
  for (const auto& process : processes_) {
    if (!process->is_overdue) until = std::min(until, process->deadline);
    polled.push_back({.fd = process->pipe_end, .events = POLLIN, .revents = 0});
  }
  const auto timeout = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
  poll(polled.data(), polled.size(), static_cast<int>(std::max<std::int64_t>(timeout, 0)));

  std::vector<ProcessOutcome> outcomes;
  for (auto& process : processes_) {
    if (!process->receive()) {
      outcomes.push_back(process->finish(limits_));
      process.reset();
    } else if (!process->is_overdue && Clock::now() >= process->deadline) {
      process->is_overdue = true;
      kill(process->id, SIGKILL);
    }
  }
  std::erase(processes_, nullptr);
  return outcomes;
}

}  // namespace mdbd
