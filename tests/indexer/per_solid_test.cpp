// The solids of an assembly as models.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "indexer/indexer.h"
#include "tests/brep/occt_solids.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

struct TestObserver final : IndexObserver {
  void on_start(std::size_t models) override { total = models; }
  void on_more_models(std::size_t models) override { total += models; }
  void on_model_done(bool) override { ++done; }
  void on_failure(const IndexFailure&) override {}
  void on_wait() override {}
  bool is_interrupted() override { return done >= interrupt_after; }

  std::size_t total = 0;
  std::size_t done = 0;
  std::size_t interrupt_after = 1000;
};

OcctSolid cube(double x, double size) { return OcctSolid::box({x, 0, 0}, {x + size, size, size}); }

const OcctSolid pair = cube(0, 1).beside(cube(10, 2));
const OcctSolid triple = pair.beside(cube(20, 3));

class Collection {
 public:
  Collection() { fs::create_directory(models); }

  IndexSummary run(std::optional<bool> is_per_solid = std::nullopt) {
    options.is_per_solid = is_per_solid;
    fs::remove(log);
    observer = {};
    observer.interrupt_after = interrupt_after;
    return run_index(discover(std::vector<fs::path>{root}), options, describe, *store, observer);
  }

  std::size_t descriptions() const {
    std::error_code missing;
    const auto size = fs::file_size(log, missing);
    return missing ? 0 : size;
  }

  /// The names of all records, in order; failed ones end in "!".
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const ShapeRecord& record : store->shapes()) {
      names.push_back(fs::path(record.path).lexically_relative(models).string() +
                      (record.status == ShapeStatus::failed ? "!" : ""));
    }
    return names;
  }

  ShapeRecord record(std::string_view name) const {
    return store->find_by_path(models / name).value();
  }

  TemporaryDirectory folder;
  fs::path models = folder / "models";
  fs::path root = models;
  fs::path log = folder / "described";
  std::unique_ptr<ShapeStore> store = open_store(folder / "test.db", Recipe{.balls = 8});
  IndexOptions options;
  TestObserver observer;
  std::size_t interrupt_after = 1000;
  std::string refused = "none";

 private:
  DescribeFunction describe = [this](const fs::path& path) {
    std::ofstream(log, std::ios::app) << '.';
    if (path.string().ends_with(refused)) throw InvalidInput("refused");
    return describe_file(path, store->recipe());
  };
};

/// indexed, unchanged, moved, failed, removed, gone
std::vector<std::size_t> counts(const IndexSummary& summary) {
  return {summary.indexed,         summary.unchanged, summary.moved,
          summary.failures.size(), summary.removed,   summary.gone};
}

using Counts = std::vector<std::size_t>;
using Names = std::vector<std::string>;

void touch(const fs::path& path) {
  fs::last_write_time(path, fs::last_write_time(path) + std::chrono::seconds(5));
}

}  // namespace

TEST_CASE("each solid of an assembly is a model, and of a file with one the file") {
  Collection c;
  pair.write_step(c.models / "a.step");
  cube(0, 4).write_step(c.models / "one.step");
  pair.write_iges(c.models / "b.igs");
  CHECK(counts(c.run(true)) == Counts{5, 0, 0, 0, 0, 0});
  CHECK(c.names() == Names{"a.step#1", "a.step#2", "b.igs#1", "b.igs#2", "one.step"});
  CHECK(c.observer.done == c.observer.total);
  for (const char* name : {"a.step", "b.igs"}) {
    const double first = c.record(name + std::string("#1")).scale;
    const double second = c.record(name + std::string("#2")).scale;
    CHECK(first == Approx(std::sqrt(3.0) / 2));
    CHECK(second == Approx(std::sqrt(3.0)));
  }

  SECTION("an unchanged file is not read again") {
    CHECK(counts(c.run(true)) == Counts{0, 5, 0, 0, 0, 0});
    CHECK(c.observer.total == 0);
  }
  SECTION("the database goes on in that way") {
    fs::copy_file(c.models / "a.step", c.models / "c.step");
    CHECK(counts(c.run()) == Counts{2, 5, 0, 0, 0, 0});
    CHECK(c.descriptions() == 0);  // of known content
    CHECK(c.names().size() == 7);
  }
  SECTION("a file of another time and the same content is not computed again") {
    touch(c.models / "a.step");
    touch(c.models / "one.step");
    CHECK(counts(c.run()) == Counts{0, 5, 0, 0, 0, 0});
    CHECK(c.descriptions() == 0);
    CHECK(c.run().unchanged == 5);
    CHECK(c.observer.total == 0);
  }
  SECTION("a file that is moved takes its solids along") {
    const std::int64_t id = c.record("a.step#2").id;
    fs::rename(c.models / "a.step", c.models / "z.step");
    CHECK(counts(c.run()) == Counts{0, 3, 2, 0, 0, 0});
    CHECK(c.record("z.step#2").id == id);
    CHECK(c.names().size() == 5);
  }
  SECTION("solids of a file that is gone are gone, and removed with it") {
    fs::remove(c.models / "a.step");
    CHECK(counts(c.run()) == Counts{0, 3, 0, 0, 0, 2});
    c.options.prune = true;
    CHECK(counts(c.run()) == Counts{0, 3, 0, 0, 2, 0});
    CHECK(c.names() == Names{"b.igs#1", "b.igs#2", "one.step"});
  }
  SECTION("all of it can be computed anew") {
    c.options.force = true;
    CHECK(counts(c.run()) == Counts{5, 0, 0, 0, 0, 0});
    CHECK(c.descriptions() == 5);
  }
}

TEST_CASE("a file that has changed has the solids that it has now") {
  Collection c;
  const fs::path path = c.models / "a.step";
  triple.write_step(path);
  CHECK(c.run(true).indexed == 3);
  const std::int64_t id = c.record("a.step#1").id;

  pair.write_step(path);
  touch(path);
  CHECK(counts(c.run()) == Counts{2, 0, 0, 0, 1, 0});
  CHECK(c.names() == Names{"a.step#1", "a.step#2"});
  CHECK(c.record("a.step#1").id == id);

  cube(0, 4).write_step(path);
  CHECK(counts(c.run()) == Counts{1, 0, 0, 0, 2, 0});
  CHECK(c.names() == Names{"a.step"});

  triple.write_step(path);
  CHECK(counts(c.run(true)) == Counts{3, 0, 0, 0, 1, 0});
  CHECK(c.names() == Names{"a.step#1", "a.step#2", "a.step#3"});

  c.folder.write("models/a.step", "no STEP file");
  CHECK(counts(c.run(true)) == Counts{0, 0, 0, 1, 3, 0});
  CHECK(c.names() == Names{"a.step!"});
  CHECK(c.run(true).failures.at(0).is_old);  // it is not tried again
}

TEST_CASE("assemblies are divided, or made whole again, when that is asked for") {
  Collection c;
  pair.write_step(c.models / "a.step");
  cube(0, 4).write_step(c.models / "one.step");
  CHECK(counts(c.run()) == Counts{2, 0, 0, 0, 0, 0});
  CHECK(counts(c.run(true)) == Counts{2, 1, 0, 0, 1, 0});
  CHECK(c.names() == Names{"a.step#1", "a.step#2", "one.step"});
  CHECK(counts(c.run(false)) == Counts{1, 1, 0, 0, 2, 0});
  CHECK(c.names() == Names{"a.step", "one.step"});
  CHECK(counts(c.run()) == Counts{0, 2, 0, 0, 0, 0});
}

TEST_CASE("an assembly that failed as a whole is divided when that is asked for") {
  Collection c;
  pair.write_step(c.models / "a.step");
  c.refused = "a.step";
  CHECK(c.run().failures.size() == 1);
  CHECK(counts(c.run(true)) == Counts{2, 0, 0, 0, 1, 0});
  CHECK(c.names() == Names{"a.step#1", "a.step#2"});
}

TEST_CASE("a solid that fails costs itself, and is not tried again") {
  Collection c;
  triple.write_step(c.models / "a.step");
  c.refused = GENERATE("#1", "#2");
  const IndexSummary summary = c.run(true);
  CHECK(counts(summary) == Counts{2, 0, 0, 1, 0, 0});
  CHECK_THAT(summary.failures.at(0).path, Contains("a.step" + c.refused));
  CHECK(summary.failures.at(0).reason == "refused");
  c.options.prune = true;
  CHECK(counts(c.run(true)) == Counts{0, 2, 0, 1, 0, 0});
  CHECK(c.descriptions() == 0);
  CHECK(c.names().size() == 3);
}

TEST_CASE("a run that ends in the middle of an assembly is continued") {
  Collection c;
  triple.write_step(c.models / "a.step");
  c.interrupt_after = 2;  // the count, and one solid
  const IndexSummary summary = c.run(true);
  CHECK(summary.is_interrupted);
  CHECK(summary.left == 2);
  CHECK(c.names() == Names{"a.step#1"});
  c.interrupt_after = 1000;
  CHECK(counts(c.run(true)) == Counts{2, 1, 0, 0, 0, 0});
  CHECK(c.names().size() == 3);
}

TEST_CASE("one file alone is divided, and a name with a # is but a name") {
  Collection c;
  pair.write_step(c.models / "a#3.step");
  pair.beside(cube(20, 5)).write_step(c.models / "b.step");
  c.folder.write("models/b.step#2", "not a model");
  c.root = c.models / "a#3.step";
  CHECK(c.run(true).indexed == 2);
  CHECK(c.names() == Names{"a#3.step#1", "a#3.step#2"});
  cube(0, 1).write_step(c.root);
  CHECK(c.run(true).removed == 2);
  CHECK(c.names() == Names{"a#3.step"});
  c.root = c.models;
  CHECK(counts(c.run(true)) == Counts{3, 1, 0, 0, 0, 0});
}
