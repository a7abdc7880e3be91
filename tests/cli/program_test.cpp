#include "cli/program.h"

#include <new>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include "features/core/errors.h"

using namespace mdbd;

namespace {

/// Runs a program of one option that takes a number.
int run(std::vector<std::string> arguments, const std::function<ExitCode()>& body) {
  CLI::App app("a test", "mdbd-test");
  int number = 0;
  app.add_option("--number", number);
  arguments.insert(arguments.begin(), "mdbd-test");
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  return run_program(app, static_cast<int>(pointers.size()), pointers.data(), body);
}

}  // namespace

TEST_CASE("the body's exit code is the program's") {
  CHECK(run({}, [] { return ExitCode::done; }) == 0);
  CHECK(run({}, [] { return ExitCode::failed; }) == 1);
  CHECK(run({"--number", "3"}, [] { return ExitCode::partial; }) == 3);
}

TEST_CASE("exceptions are failures") {
  CHECK(run({}, []() -> ExitCode { throw InvalidInput("bad"); }) == 1);
  CHECK(run({}, []() -> ExitCode { throw IoError("missing"); }) == 1);
  CHECK(run({}, []() -> ExitCode { throw StoreError("locked"); }) == 1);
  CHECK(run({}, []() -> ExitCode { throw std::bad_alloc(); }) == 1);
  CHECK(run({}, []() -> ExitCode { throw 42; }) == 1);
}

TEST_CASE("a wrong command line is wrong usage and help is none") {
  const auto body = []() -> ExitCode { throw std::logic_error("must not run"); };
  CHECK(run({"--nonsense"}, body) == 2);
  CHECK(run({"--number", "three"}, body) == 2);
  CHECK(run({"--help"}, body) == 0);
  CHECK(run({"--version"}, body) == 0);
}
