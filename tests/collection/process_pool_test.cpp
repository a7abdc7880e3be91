#include "collection/process_pool.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <system_error>
#include <thread>

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "features/core/errors.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Contains;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool limits_memory = false;
#else
constexpr bool limits_memory = true;
#endif

namespace {

std::map<std::size_t, ProcessOutcome> run_all(std::size_t processes, const ProcessLimits& limits,
                                              const std::vector<ProcessWork>& jobs) {
  ProcessPool pool(processes, limits);
  std::map<std::size_t, ProcessOutcome> outcomes;
  std::size_t next = 0;
  while (next < jobs.size() || !pool.is_empty()) {
    while (next < jobs.size() && !pool.is_full()) {
      pool.start(next, jobs[next]);
      ++next;
    }
    for (ProcessOutcome& outcome : pool.wait(std::chrono::milliseconds(100))) {
      CHECK(outcomes.emplace(outcome.job, std::move(outcome)).second);
    }
  }
  return outcomes;
}

ProcessOutcome run_one(const ProcessWork& work, const ProcessLimits& limits = {}) {
  return run_all(1, limits, {work}).at(0);
}

void limit(int resource, rlim_t value) {
  const rlimit limits{.rlim_cur = value, .rlim_max = value};
  setrlimit(resource, &limits);
}

/// For the rest of this process; root is not limited, so it becomes another user.
void forbid_processes() {
  limit(RLIMIT_NPROC, 0);
  if (geteuid() == 0 && setuid(65534) != 0) _exit(1);
}

std::string failure_of_start() {
  ProcessPool pool(1, {});
  try {
    pool.start(0, [](const SendOutput&) {});
  } catch (const IoError&) {
    return "a fault of the file; ";
  } catch (const std::system_error& error) {
    return std::string(error.what()) + "; ";
  }
  return "started; ";
}

}  // namespace

TEST_CASE("a job's output arrives whole") {
  const std::string large(5'000'000, 'x');
  const ProcessOutcome outcome = run_one([&](const SendOutput& send) {
    send("first ");
    send(large);
  });
  CHECK(outcome.end == ProcessEnd::finished);
  CHECK(outcome.output == "first " + large);
  CHECK(outcome.reason.empty());
}

TEST_CASE("many quick jobs give the same with one process and with four") {
  std::vector<ProcessWork> jobs;
  for (int i = 0; i < 60; ++i) {
    jobs.emplace_back([i](const SendOutput& send) { send(std::string(i, 'a')); });
  }
  for (const std::size_t processes : {1, 4}) {
    const auto outcomes = run_all(processes, {}, jobs);
    REQUIRE(outcomes.size() == jobs.size());
    for (const auto& [job, outcome] : outcomes) CHECK(outcome.output == std::string(job, 'a'));
  }
}

TEST_CASE("a crash costs its own job only") {
  const auto outcomes =
      run_all(2, {},
              {[](const SendOutput& send) {
                 send("before");
                 std::signal(SIGSEGV, SIG_DFL);
                 std::raise(SIGSEGV);
               },
               [](const SendOutput&) { std::abort(); }, [](const SendOutput&) { std::_Exit(0); },
               [](const SendOutput&) { throw std::runtime_error("lost"); },
               [](const SendOutput& send) { send("fine"); }});
  CHECK(outcomes.at(0).end == ProcessEnd::died);
  CHECK(outcomes.at(0).output == "before");
  CHECK_THAT(outcomes.at(0).reason, Contains("died (signal 11, Segmentation fault)"));
  CHECK(outcomes.at(1).end == ProcessEnd::died);
  CHECK_THAT(outcomes.at(1).reason, Contains("signal 6, Aborted"));
  CHECK(outcomes.at(2).end == ProcessEnd::died);
  CHECK_THAT(outcomes.at(2).reason, Contains("ended with code 0"));
  CHECK(outcomes.at(3).end == ProcessEnd::died);
  CHECK(outcomes.at(4).end == ProcessEnd::finished);
  CHECK(outcomes.at(4).output == "fine");
}

TEST_CASE("a hanging job is ended by its time budget") {
  ProcessLimits limits;
  limits.time = std::chrono::duration<double>(0.3);
  const ProcessOutcome outcome = run_one(
      [](const SendOutput& send) {
        send("started");
        while (true) std::this_thread::sleep_for(std::chrono::hours(1));
      },
      limits);
  CHECK(outcome.end == ProcessEnd::out_of_time);
  CHECK(outcome.output == "started");
  CHECK(outcome.reason == "took longer than the time budget of 0.3 s (--model-time)");
  CHECK(outcome.seconds >= 0.3);
}

TEST_CASE("a memory bomb is ended by its memory budget") {
  if (!limits_memory) return;
  ProcessLimits limits;
  limits.memory = 64 << 20;
  const ProcessOutcome outcome = run_one(
      [](const SendOutput&) {
        std::vector<std::string> eaten;
        while (true) eaten.emplace_back(1 << 20, 'x');
      },
      limits);
  CHECK(outcome.end == ProcessEnd::out_of_memory);
  CHECK(outcome.reason == "needs more than the memory budget of 64 MiB (--model-memory)");
}

TEST_CASE("the memory budget is that of the job, not of the program") {
  const std::string ballast(100 << 20, 'x');
  ProcessLimits limits;
  limits.memory = 64 << 20;
  const ProcessOutcome outcome = run_one(
      [&](const SendOutput& send) { send(std::string(20 << 20, ballast.front()).substr(0, 3)); },
      limits);
  CHECK(outcome.output == "xxx");
}

TEST_CASE("a kill from outside is taken for want of memory") {
  const ProcessOutcome outcome = run_one([](const SendOutput&) { std::raise(SIGKILL); });
  CHECK(outcome.end == ProcessEnd::out_of_memory);
  CHECK_THAT(outcome.reason, Contains("killed"));
}

TEST_CASE("a job does not hear the signals that end the program") {
  const ProcessOutcome outcome = run_one([](const SendOutput& send) {
    std::raise(SIGINT);
    std::raise(SIGTERM);
    send("still here");
  });
  CHECK(outcome.output == "still here");
}

TEST_CASE("a job has no files of the program") {
  std::FILE* file = std::tmpfile();
  REQUIRE(file != nullptr);
  const int descriptor = fileno(file);
  const ProcessOutcome outcome = run_one([=](const SendOutput& send) {
    send(descriptor > 3 && write(descriptor, "x", 1) == 1 ? "open" : "closed");
  });
  std::fclose(file);
  CHECK(outcome.output == "closed");
}

TEST_CASE("a system that gives no process or pipe is no fault of a file, and nothing stays open") {
  const ProcessOutcome outcome = run_one([](const SendOutput& send) {
    forbid_processes();
    send(failure_of_start());
    send(std::to_string(dup(STDIN_FILENO)));  // the lowest that is free
    limit(RLIMIT_NOFILE, 5);
    send(failure_of_start());
  });
  CHECK(outcome.output ==
        "cannot start a process: Resource temporarily unavailable; 4"
        "cannot create a pipe: Too many open files; ");
}

TEST_CASE("a pool that ends takes its jobs with it") {
  test::TemporaryDirectory folder;
  const std::string note = folder / "process";
  {
    ProcessPool pool(1, {});
    pool.start(0, [&](const SendOutput&) {
      std::ofstream(note + ".part") << getpid();
      std::filesystem::rename(note + ".part", note);
      std::this_thread::sleep_for(std::chrono::hours(1));
    });
    CHECK(pool.is_full());
    while (!std::filesystem::exists(note)) pool.wait(std::chrono::milliseconds(10));
  }
  pid_t process = 0;
  std::ifstream(note) >> process;
  REQUIRE(process > 0);
  CHECK(kill(process, 0) == -1);
}
