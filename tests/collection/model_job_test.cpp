#include "collection/model_job.h"

#include <limits>
#include <new>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/shape_io/content_hash.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;

namespace {

ShapeDescription description() {
  ShapeDescription shape;
  shape.format = "off";
  shape.representation = "mesh";
  shape.statistics = R"({"faces":12})";
  shape.decomposition.balls = {{{0.1, 1.0 / 3.0, -1e-300}, 0.5}, {{1, 2, 3}, 0.25}};
  shape.decomposition.scale = 2.0 / 3.0;
  shape.descriptor.values = {0.1f, 0.2f};
  shape.descriptor.radius_count = 1;
  shape.thumbnail = std::string("\x89\0\xff", 3);
  return shape;
}

ProcessOutcome run(const std::filesystem::path& path, const DescribeFunction& describe,
                   const std::unordered_set<std::string>& known = {}) {
  ProcessOutcome outcome;
  outcome.seconds = 1.5;
  run_model_job(path, known, describe, [&](std::string_view bytes) { outcome.output += bytes; });
  return outcome;
}

template <typename Exception>
ModelResult result_of(const std::filesystem::path& path, const Exception& exception) {
  return read_model_result(run(path, [&](const auto&) -> ShapeDescription { throw exception; }));
}

}  // namespace

TEST_CASE("a description arrives bit for bit") {
  test::TemporaryDirectory folder;
  const auto path = folder.write("a.off", "content");
  const ShapeDescription sent = description();
  const ModelResult result = read_model_result(run(path, [&](const auto&) { return sent; }));
  CHECK_FALSE(result.is_known);
  CHECK(result.record.status == ShapeStatus::indexed);
  CHECK(result.record.failure == FailureKind::none);
  CHECK(result.record.content_hash == content_hash(path));
  CHECK(result.record.format == "off");
  CHECK(result.record.representation == "mesh");
  CHECK(result.record.statistics == sent.statistics);
  CHECK(result.record.scale == sent.decomposition.scale);
  CHECK(result.record.reason.empty());
  CHECK(result.record.seconds == 1.5);
  CHECK(result.data.signature == sent.descriptor.values);
  REQUIRE(result.data.balls.size() == 2);
  CHECK(result.data.balls[0].center == sent.decomposition.balls[0].center);
  CHECK(result.data.balls[1].radius == 0.25);
  CHECK(result.data.thumbnail == sent.thumbnail);
}

TEST_CASE("fewer balls come with their reason") {
  test::TemporaryDirectory folder;
  ShapeDescription few = description();
  few.decomposition.termination = Termination::minimum_radius;
  const ModelResult result =
      read_model_result(run(folder.write("a.off", ""), [&](const auto&) { return few; }));
  CHECK(result.record.status == ShapeStatus::indexed);
  CHECK(result.record.reason == "2 balls: minimum radius reached");
}

TEST_CASE("known content is not described") {
  test::TemporaryDirectory folder;
  const auto path = folder.write("a.off", "content");
  const auto never = [](const auto&) -> ShapeDescription { throw std::logic_error("called"); };
  const std::string key = content_key(content_hash(path), "elsewhere.OFF");
  const ModelResult result = read_model_result(run(path, never, {key}));
  CHECK(result.is_known);
  CHECK(result.record.content_hash == content_hash(path));
}

TEST_CASE("each kind of failure is told apart") {
  test::TemporaryDirectory folder;
  const auto path = folder.write("a.off", "content");
  const ModelResult content = result_of(path, InvalidInput("no \xff solid"));
  CHECK(content.record.status == ShapeStatus::failed);
  CHECK(content.record.failure == FailureKind::content);
  CHECK(content.record.reason == "no \xff solid");
  CHECK(content.record.content_hash == content_hash(path));
  CHECK(result_of(path, IoError("gone")).record.failure == FailureKind::unreadable);
  CHECK(result_of(path, IoError("gone")).record.content_hash.empty());
  CHECK(result_of(path, std::runtime_error("bug")).record.failure == FailureKind::crash);
  CHECK(result_of(path, 42).record.failure == FailureKind::crash);
  CHECK_THROWS_AS(result_of(path, std::bad_alloc()), std::bad_alloc);
  const ModelResult missing = result_of(folder / "missing.off", 42);
  CHECK(missing.record.failure == FailureKind::unreadable);
  CHECK(missing.record.content_hash.empty());
  CHECK_FALSE(missing.record.reason.empty());
}

TEST_CASE("numbers that overflow are a failure of the model") {
  test::TemporaryDirectory folder;
  ShapeDescription huge = description();
  huge.decomposition.scale = std::numeric_limits<double>::infinity();
  const ModelResult result =
      read_model_result(run(folder.write("a.off", ""), [&](const auto&) { return huge; }));
  CHECK(result.record.failure == FailureKind::content);
  CHECK(result.data.balls.empty());
}

TEST_CASE("a job that ended early leaves its hash and the reason") {
  const std::string hash(32, 'a');
  ProcessOutcome outcome{0, ProcessEnd::out_of_time, hash, "too long", 60.0};
  ModelResult result = read_model_result(outcome);
  CHECK(result.record.content_hash == hash);
  CHECK(result.record.failure == FailureKind::budget);
  CHECK(result.record.reason == "too long");
  outcome.end = ProcessEnd::out_of_memory;
  CHECK(read_model_result(outcome).record.failure == FailureKind::budget);
  outcome.end = ProcessEnd::died;
  outcome.output.clear();
  result = read_model_result(outcome);
  CHECK(result.record.failure == FailureKind::crash);
  CHECK(result.record.content_hash.empty());
}
