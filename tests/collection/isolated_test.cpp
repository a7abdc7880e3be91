#include "collection/isolated.h"

#include <csignal>
#include <new>
#include <stdexcept>
#include <thread>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "features/core/errors.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Contains;

TEST_CASE(
    "a computation in a process of its own returns what it computed, or throws what it threw") {
  CHECK(compute_isolated("a.off", {}, [] { return std::string("a\0b", 3); }) ==
        std::string("a\0b", 3));
  CHECK(compute_isolated("a.off", {}, [] { return std::string(); }).empty());
  CHECK_THROWS_WITH(compute_isolated("a.off", {}, []() -> std::string { throw IoError("gone"); }),
                    "gone");
  CHECK_THROWS_AS(compute_isolated("a.off", {}, []() -> std::string { throw IoError("gone"); }),
                  IoError);
  CHECK_THROWS_AS(compute_isolated("a.off", {}, []() -> std::string { throw InvalidInput("bad"); }),
                  InvalidInput);
}

TEST_CASE("a failure that nobody foresaw names the file") {
  CHECK_THROWS_WITH(
      compute_isolated("a.off", {}, []() -> std::string { throw std::runtime_error("odd"); }),
      "a.off: unexpected failure: odd");
  CHECK_THROWS_AS(
      compute_isolated("a.off", {}, []() -> std::string { throw std::runtime_error("odd"); }),
      InvalidInput);
}

TEST_CASE("a crash, a hang and a memory bomb become exceptions with the reason") {
  CHECK_THROWS_WITH(compute_isolated("a.off", {},
                                     []() -> std::string {
                                       std::raise(SIGKILL);
                                       return {};
                                     }),
                    Contains("a.off: the system killed"));
  CHECK_THROWS_WITH(compute_isolated("a.off", {},
                                     []() -> std::string {
                                       std::signal(SIGSEGV, SIG_DFL);  // whoever handles it
                                       std::raise(SIGSEGV);
                                       return {};
                                     }),
                    Contains("a.off: the process reading it died (signal 11"));
  CHECK_THROWS_WITH(compute_isolated("a.off", {}, []() -> std::string { _exit(7); }),
                    Contains("a.off: the process reading it ended with code 7"));
  const ProcessLimits brief{.time = std::chrono::milliseconds(100)};
  CHECK_THROWS_WITH(compute_isolated("a.off", brief,
                                     []() -> std::string {
                                       std::this_thread::sleep_for(std::chrono::seconds(60));
                                       return {};
                                     }),
                    Contains("took longer than the time budget"));
  CHECK_THROWS_WITH(compute_isolated("a.off", {}, []() -> std::string { throw std::bad_alloc(); }),
                    Contains("needs more than the memory budget"));
}

#ifndef __SANITIZE_ADDRESS__  // it reserves address space without end
TEST_CASE("a real memory bomb becomes an exception with the reason") {
  const ProcessLimits small{.memory = 64 << 20};
  const auto bomb = []() -> std::string {
    std::string bytes(1 << 20, 'x');
    while (true) bytes += bytes;
  };
  CHECK_THROWS_WITH(compute_isolated("a.off", small, bomb),
                    Contains("a.off: needs more than the memory budget of 64 MiB"));
}
#endif

TEST_CASE("a description from another process is the same to the bit") {
  const TemporaryDirectory folder;
  Recipe recipe;
  recipe.balls = 60;
  const auto path = folder.write("a.off", to_off(make_torus(1.0, 0.4, 20, 10)));
  const ShapeDescription here = describe_file(path, recipe);
  const ShapeDescription there = describe_isolated(path, recipe, {});
  CHECK(there.format == here.format);
  CHECK(there.representation == here.representation);
  CHECK(there.statistics == here.statistics);
  CHECK(there.descriptor.values == here.descriptor.values);
  CHECK(there.descriptor.radius_count == here.descriptor.radius_count);
  CHECK(there.fused == here.fused);
  CHECK(there.decomposition.scale == here.decomposition.scale);
  CHECK(there.decomposition.is_certified == here.decomposition.is_certified);
  CHECK(there.decomposition.termination == here.decomposition.termination);
  REQUIRE(there.decomposition.balls.size() == here.decomposition.balls.size());
  for (std::size_t i = 0; i < here.decomposition.balls.size(); ++i) {
    CHECK(there.decomposition.balls[i].center == here.decomposition.balls[i].center);
    CHECK(there.decomposition.balls[i].radius == here.decomposition.balls[i].radius);
  }

  CHECK_THROWS_AS(describe_isolated(folder / "none.off", recipe, {}), IoError);
  CHECK_THROWS_AS(describe_isolated(folder.write("b.off", "OFF"), recipe, {}), InvalidInput);
}
