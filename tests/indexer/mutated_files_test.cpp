// However files are damaged, a run comes to its end, says what became of each, and indexes the good
// ones beside them. MDBD_MUTATIONS is the number of files for each reader.
#include "tests/support/mutated_files.h"

#include <chrono>
#include <cstdlib>
#include <string>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "indexer/indexer.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

class SilentObserver final : public IndexObserver {
 public:
  void on_start(std::size_t) override {}
  void on_model_done(bool) override {}
  void on_failure(const IndexFailure&) override {}
  void on_wait() override {}
  bool is_interrupted() override { return false; }
};

int mutation_count() {
  const char* text = std::getenv("MDBD_MUTATIONS");
  return text == nullptr ? 20 : std::atoi(text);
}

/// @param crashes whether a reader may crash, which costs its process
void check_mutated_files(const std::vector<FilesOfReader>& readers, bool crashes) {
  Recipe recipe;
  recipe.balls = 2;
  recipe.radius_tolerance = 0.1;
  std::uint32_t seed = 1;
  for (const auto& [ending, contents] : readers) {
    INFO(ending);
    const TemporaryDirectory folder;
    std::filesystem::create_directory(folder / "models");
    const auto path = [](const char* kind, std::size_t i, const std::string& end) {
      return fmt::format("models/{}{}{}", kind, i, end);
    };
    for (std::size_t i = 0; i < contents.size(); ++i) {
      folder.write(path("good", i, ending), contents[i]);
    }
    Mutator mutator(seed++);
    for (int i = 0; i < mutation_count(); ++i) {
      folder.write(path("bad", i, ending), mutator.mutate(contents[i % contents.size()]));
    }

    const auto store = open_store(folder / "a.db", recipe);
    SilentObserver observer;
    IndexOptions options;
    options.limits.time = std::chrono::seconds(10);
    const Discovery found = discover(std::vector{folder / "models"});
    const DescribeFunction describe = [&](const auto& file) { return describe_file(file, recipe); };
    const IndexSummary summary = run_index(found, options, describe, *store, observer);

    CHECK(summary.indexed + summary.unchanged + summary.failures.size() == found.files.size());
    for (const ShapeRecord& record : store->shapes()) {
      INFO(record.path << ": " << record.reason);
      const bool is_good = record.path.find("good") != record.path.npos;
      if (is_good && record.status != ShapeStatus::indexed) FAIL("a good model failed");
      if (record.status != ShapeStatus::failed) continue;
      if (record.reason.empty()) FAIL("no reason");
      // A shape may be absurd enough to be searched for too long, but no reader of ours may crash.
      if (crashes) continue;
      if (record.failure == FailureKind::crash) FAIL("contained, but not refused by the reader");
    }
    CHECK(store->shapes().size() == found.files.size());
  }
}

}  // namespace

TEST_CASE("mutated meshes cost themselves and nothing else") {
  check_mutated_files(sound_meshes(), false);
}

TEST_CASE("mutated point clouds cost themselves and nothing else") {
  check_mutated_files(sound_clouds(), false);
}

TEST_CASE("mutated scenes cost themselves and nothing else") {
  check_mutated_files(sound_scenes(), true);
}

TEST_CASE("mutated drawings cost themselves and nothing else") {
  check_mutated_files(sound_drawings(), false);
}

TEST_CASE("mutated solids cost themselves and nothing else") {
  check_mutated_files(sound_solids(), false);
}
