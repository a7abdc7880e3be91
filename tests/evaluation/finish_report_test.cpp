#include "evaluation/finish_report.h"

#include <catch2/catch.hpp>

#include "tests/evaluation/recording_progress.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Matchers::Contains;

namespace {

/// A collection of one model that cannot be read, described once.
struct FailedCollection {
  FailedCollection() {
    directory.write("models/chair/empty.off", "");
    collection = find_labelled_models(directory / "models", 0, 1);
    cache.describe(collection.models, clean_variant());
  }

  test::TemporaryDirectory directory;
  test::RecordingProgress progress;
  LabelledCollection collection;
  ModelCache cache{{.folder = directory / "cache"}, {}, progress};
  EvaluationInput input{collection, cache, 7};
};

}  // namespace

TEST_CASE("a command line is quoted so that it can be typed again") {
  const std::vector<const char*> words = {"mdbd-evaluate", "noise", "my models",
                                          "it's",          "",      "0.5%"};
  CHECK(join_command(words) == "mdbd-evaluate noise 'my models' 'it'\\''s' '' 0.5%");
}

TEST_CASE("a report is completed with its origin and the failures, before its own notes") {
  const FailedCollection failed;
  Report report;
  report.notes = {"its own"};
  finish_report(report, failed.input, {"the command", "1.2.3"});

  std::vector<std::string> names;
  for (const auto& entry : report.provenance) names.push_back(entry.first);
  CHECK(names == std::vector<std::string>{"command", "version", "collection", "recipe", "seed"});
  CHECK(report.provenance[0].second == "the command");
  CHECK_THAT(report.provenance[2].second, Contains("models: 1 model in 1 class"));
  CHECK_THAT(report.provenance[3].second, Contains("balls 500"));
  CHECK(report.provenance[4].second == "7");

  REQUIRE(report.notes.size() == 3);  // one of the collection: its class has one model
  CHECK_THAT(report.notes[1], Contains("1 failure: chair/empty.off (") && Contains("empty"));
  CHECK(report.notes[2] == "its own");
  REQUIRE(report.sections.size() == 1);
  CHECK(std::get<Table>(report.sections[0].blocks[0]).rows.size() == 1);
  CHECK(report.data["failures"][0]["model"] == "chair/empty.off");
  CHECK(report.data["collection"]["models"] == 1);
  CHECK(has_failures(failed.input));
}
