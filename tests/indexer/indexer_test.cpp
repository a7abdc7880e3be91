#include "indexer/indexer.h"

#include <csignal>
#include <fstream>
#include <thread>
#include <utility>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/descriptor/fused_signature.h"
#include "indexer/dry_run_store.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

class TestObserver final : public IndexObserver {
 public:
  void on_start(std::size_t models) override { started = models; }
  void on_model_done(bool has_failed) override {
    ++done;
    failed += has_failed ? 1 : 0;
  }
  void on_failure(const IndexFailure& failure) override { reasons.push_back(failure.reason); }
  void on_wait() override {}
  bool is_interrupted() override { return done >= interrupt_after; }

  std::size_t started = 0;
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t interrupt_after = 1000;
  std::vector<std::string> reasons;
};

/// A folder of "models", a database, and a description that does what the content of a file says.
class Collection {
 public:
  Collection() { fs::create_directory(models); }

  IndexSummary run(IndexOptions options = {}) { return run({models}, options); }

  IndexSummary run(const std::vector<fs::path>& paths, IndexOptions options = {}) {
    const Discovery found = discover(paths);
    observer = {};
    observer.interrupt_after = interrupt_after;
    options.limits.time = std::chrono::duration<double>(time_budget);
    fs::remove(log);
    return run_index(found, options, describe, is_dry_run ? *dry_store() : *store, observer);
  }

  fs::path write(std::string_view name, std::string_view content) {
    return folder.write("models/" + std::string(name), content);
  }

  /// How many files were described in the last run.
  std::size_t described() const {
    std::error_code missing;
    const auto size = fs::file_size(log, missing);
    return missing ? 0 : size;
  }

  std::optional<ShapeRecord> record(std::string_view name) const {
    return store->find_by_path(models / name);
  }

  test::TemporaryDirectory folder;
  fs::path models = folder / "models";
  fs::path log = folder / "described";
  fs::path database = folder / "test.db";
  std::unique_ptr<ShapeStore> store = open_store(database);
  std::unique_ptr<ShapeStore> forgetful;
  TestObserver observer;
  std::size_t interrupt_after = 1000;
  double time_budget = 60.0;
  bool is_dry_run = false;

 private:
  ShapeStore* dry_store() {
    forgetful = std::make_unique<DryRunStore>(open_store_read_only(database), store->recipe());
    return forgetful.get();
  }

  DescribeFunction describe = [this](const fs::path& path) {
    std::ofstream(log, std::ios::app) << '.';
    std::string content;
    std::getline(std::ifstream(path), content, '\0');
    if (content.starts_with("bad")) throw InvalidInput("no solid");
    if (content.starts_with("io")) throw IoError("read error");
    if (content.starts_with("crash")) std::raise(SIGKILL);
    if (content.starts_with("hang")) std::this_thread::sleep_for(std::chrono::hours(1));
    ShapeDescription shape;
    shape.format = "off";
    shape.representation = "mesh";
    shape.decomposition.balls = {{{0, 0, 0}, static_cast<double>(1 + content.size())}};
    shape.decomposition.scale = static_cast<double>(1 + content.size());
    shape.descriptor.values.assign(100, static_cast<float>(content.size()));
    return shape;
  };
};

/// indexed, unchanged, moved, failed, removed, gone
std::vector<std::size_t> counts(const IndexSummary& summary) {
  return {summary.indexed,         summary.unchanged, summary.moved,
          summary.failures.size(), summary.removed,   summary.gone};
}

using Counts = std::vector<std::size_t>;

}  // namespace

TEST_CASE("a second run on an unchanged folder does nothing") {
  Collection c;
  c.write("a.off", "A");
  c.write("deep/b.off", "BB");
  CHECK(counts(c.run()) == Counts{2, 0, 0, 0, 0, 0});
  CHECK(c.described() == 2);
  CHECK(c.observer.started == 2);
  CHECK(c.observer.done == 2);
  CHECK(c.record("deep/b.off")->scale == 3.0);
  CHECK(c.store->data(c.record("a.off")->id).signature == std::vector<float>(100, 1.0f));
  CHECK(counts(c.run()) == Counts{0, 2, 0, 0, 0, 0});
  CHECK(c.described() == 0);
  CHECK(c.observer.started == 0);
}

TEST_CASE("models without mdbd-fused gain it from their balls, and nothing is decomposed again") {
  Collection c;
  c.write("a.off", "A");
  c.write("b.off", "BB");
  c.write("bad.off", "bad");
  CHECK(c.run().completed == 2);  // the description of these tests has none
  const std::int64_t id = c.record("b.off")->id;
  CHECK(c.store->data(id).fused == compute_fused_signature(c.store->data(id).balls));
  CHECK(c.run().completed == 0);
  c.store->put_vector(id, "mdbd-fused/0", std::vector<float>{1});
  ShapeData without = c.store->data(id);
  without.fused.clear();
  c.store->put(*c.record("b.off"), without);
  c.is_dry_run = true;
  CHECK(c.run().completed == 1);
  c.is_dry_run = false;
  CHECK(c.run().completed == 1);
  CHECK(c.described() == 0);
  CHECK(c.store->vectors(stored_mdbd_fused).size() == 2);
}

TEST_CASE("mdbd-fused of an older number is replaced from the balls") {
  Collection c;
  c.write("a.off", "A");
  c.run();
  const std::int64_t id = c.record("a.off")->id;
  ShapeData data = c.store->data(id);
  const std::vector<float> current = std::exchange(data.fused, {});
  c.store->put(*c.record("a.off"), data);
  c.store->put_vector(id, "mdbd-fused/1", std::vector<float>(274, 1.0F));
  CHECK(c.run().completed == 1);
  CHECK(c.store->data(id).fused == current);
  CHECK(current.size() == fused_size);
  CHECK(c.store->vectors("mdbd-fused/1").empty());
}

TEST_CASE("records do not depend on the number of jobs") {
  const auto run = [](std::size_t jobs) {
    Collection c;
    for (int i = 0; i < 20; ++i) c.write(std::to_string(i) + ".off", std::string(i, 'x'));
    IndexOptions options;
    options.jobs = jobs;
    CHECK(c.run(options).indexed == 20);
    std::vector<std::pair<std::string, std::vector<float>>> vectors;
    for (const StoredVector vector : c.store->vectors(signature_mdbd_100)) {
      vectors.emplace_back(fs::path(vector.path).filename(),
                           std::vector(vector.values.begin(), vector.values.end()));
    }
    return vectors;
  };
  CHECK(run(1) == run(4));
}

TEST_CASE("a touched file costs a hash, a changed one is computed again") {
  Collection c;
  const fs::path path = c.write("a.off", "A");
  c.run();
  const auto id = c.record("a.off")->id;
  fs::last_write_time(path, fs::last_write_time(path) + std::chrono::seconds(5));
  CHECK(counts(c.run()) == Counts{0, 1, 0, 0, 0, 0});
  CHECK(c.observer.started == 1);
  CHECK(c.described() == 0);
  c.run();
  CHECK(c.observer.started == 0);
  c.write("a.off", "changed");
  CHECK(counts(c.run()) == Counts{1, 0, 0, 0, 0, 0});
  CHECK(c.described() == 1);
  CHECK(c.record("a.off")->scale == 8.0);
  CHECK(c.record("a.off")->id == id);
}

TEST_CASE("a moved file keeps its record") {
  Collection c;
  c.write("a.off", "A");
  c.run();
  const auto id = c.record("a.off")->id;
  fs::rename(c.models / "a.off", c.models / "b.off");
  CHECK(counts(c.run()) == Counts{0, 0, 1, 0, 0, 0});
  CHECK(c.described() == 0);
  CHECK_FALSE(c.record("a.off"));
  CHECK(c.record("b.off")->id == id);
  CHECK(counts(c.run()) == Counts{0, 1, 0, 0, 0, 0});
}

TEST_CASE("a file moved over another takes its place") {
  Collection c;
  c.write("a.off", "A");
  c.write("b.off", "BB");
  c.run();
  fs::rename(c.models / "a.off", c.models / "b.off");
  CHECK(counts(c.run()) == Counts{0, 0, 1, 0, 0, 0});
  CHECK(c.store->shapes().size() == 1);
  CHECK(c.record("b.off")->scale == 2.0);
}

TEST_CASE("files that change places are right in the end") {
  Collection c;
  c.write("a.off", "A");
  c.write("b.off", "BB");
  c.run();
  fs::rename(c.models / "a.off", c.models / "c.tmp");
  fs::rename(c.models / "b.off", c.models / "a.off");
  fs::rename(c.models / "c.tmp", c.models / "b.off");
  IndexOptions options;
  options.jobs = GENERATE(1, 2);
  CHECK(c.run(options).failures.empty());
  CHECK(c.observer.done == 2);
  CHECK(c.record("a.off")->scale == 3.0);
  CHECK(c.record("b.off")->scale == 2.0);
  CHECK(counts(c.run()) == Counts{0, 2, 0, 0, 0, 0});
}

TEST_CASE("a copy is stored without computing") {
  Collection c;
  c.write("a.off", "A");
  c.run();
  c.write("b.off", "A");
  CHECK(counts(c.run()) == Counts{1, 1, 0, 0, 0, 0});
  CHECK(c.described() == 0);
  CHECK(c.record("a.off"));
  CHECK(c.store->data(c.record("b.off")->id).signature == std::vector<float>(100, 1.0f));
  CHECK(c.store->data(c.record("b.off")->id).balls.size() == 1);
}

TEST_CASE("a copy of a failed model is a failure of its own, not one of an earlier run") {
  Collection c;
  c.write("a.off", "bad");
  c.write("b.off", "bad");
  const IndexSummary summary = c.run();
  REQUIRE(summary.failures.size() == 2);
  CHECK_FALSE(summary.failures[0].is_old);
  CHECK_FALSE(summary.failures[1].is_old);
  CHECK(c.observer.reasons == std::vector<std::string>(2, "no solid"));
  CHECK(c.record("b.off")->status == ShapeStatus::failed);
  CHECK(c.run().failures[1].is_old);
}

TEST_CASE("the same content under another ending is another model, for it is read in another way") {
  Collection c;
  const fs::path wrong = c.write("a.stl", "bad");
  c.write("b.off", "B");
  c.run();
  fs::rename(wrong, c.models / "a.ply");
  c.write("b.obj", "B");
  c.write("c.OFF", "B");
  c.run();
  CHECK(c.described() == 2);
  CHECK(c.record("a.ply")->status == ShapeStatus::failed);
}

TEST_CASE("a file moved in from a folder not asked for leaves that folder's record") {
  Collection c;
  c.write("one/a.off", "A");
  c.write("two/b.off", "BB");
  c.run();
  fs::rename(c.models / "one/a.off", c.models / "two/a.off");
  CHECK(counts(c.run({c.models / "two"}, {})) == Counts{1, 1, 0, 0, 0, 0});
  CHECK(c.described() == 0);
  CHECK(c.record("one/a.off"));
}

TEST_CASE("vanished files are kept until they are pruned, and only in the folders asked for") {
  Collection c;
  c.write("one/a.off", "A");
  c.write("one/b.off", "BB");
  c.write("two/c.off", "CCC");
  c.run();
  fs::remove(c.models / "one/a.off");
  fs::remove(c.models / "two/c.off");
  CHECK(counts(c.run()) == Counts{0, 1, 0, 0, 0, 2});
  CHECK(c.store->shapes().size() == 3);
  IndexOptions prune;
  prune.prune = true;
  CHECK(counts(c.run({c.models / "one"}, prune)) == Counts{0, 1, 0, 0, 1, 0});
  CHECK_FALSE(c.record("one/a.off"));
  CHECK(c.record("two/c.off"));
}

TEST_CASE("pruning keeps a record whose file is there but hidden from the search") {
  Collection c;
  c.write(".hidden/a.off", "A");
  c.run({c.models / ".hidden"}, {});
  IndexOptions prune;
  prune.prune = true;
  CHECK(counts(c.run(prune)) == Counts{0, 0, 0, 0, 0, 0});
  CHECK(c.record(".hidden/a.off"));
}

TEST_CASE("force computes again") {
  Collection c;
  c.write("a.off", "A");
  c.write("b.off", "bad");
  c.run();
  IndexOptions force;
  force.force = true;
  CHECK(counts(c.run(force)) == Counts{1, 0, 0, 1, 0, 0});
  CHECK(c.described() == 2);
}

TEST_CASE("failures are stored, and tried again when there is a point in it") {
  Collection c;
  c.write("bad.off", "bad");
  c.write("crash.off", "crash");
  c.write("good.off", "good");
  c.write("io.off", "io");
  const IndexSummary first = c.run();
  CHECK(counts(first) == Counts{1, 0, 0, 3, 0, 0});
  CHECK(first.failures[0].path == c.models / "bad.off");
  CHECK(first.failures[0].reason == "no solid");
  CHECK_FALSE(first.failures[0].is_old);
  CHECK(c.observer.failed == 3);
  CHECK(c.observer.reasons.size() == 3);
  CHECK(c.record("bad.off")->failure == FailureKind::content);
  CHECK(c.record("io.off")->failure == FailureKind::unreadable);
  CHECK(c.record("io.off")->reason == "read error");

  const IndexSummary second = c.run();
  CHECK(counts(second) == Counts{0, 1, 0, 3, 0, 0});
  CHECK(c.described() == 1);  // io.off
  CHECK(second.failures[0].is_old);
  CHECK(second.failures[0].reason == "no solid");
  CHECK_FALSE(second.failures[2].is_old);
  CHECK(c.observer.reasons == std::vector<std::string>{"read error"});

  c.write("bad.off", "good now");
  CHECK(counts(c.run()) == Counts{1, 1, 0, 2, 0, 0});
  CHECK(c.record("bad.off")->status == ShapeStatus::indexed);
}

TEST_CASE("a model over its time budget is a failure that is not tried again") {
  Collection c;
  c.write("hang.off", "hang");
  c.time_budget = 0.3;
  CHECK(counts(c.run()) == Counts{0, 0, 0, 1, 0, 0});
  CHECK(c.record("hang.off")->failure == FailureKind::budget);
  CHECK_FALSE(c.record("hang.off")->content_hash.empty());
  fs::last_write_time(c.models / "hang.off", fs::file_time_type::clock::now());
  CHECK(counts(c.run()) == Counts{0, 0, 0, 1, 0, 0});
  CHECK(c.described() == 0);
}

TEST_CASE("what looks like a model and is none is stored until it is gone") {
  Collection c;
  fs::create_directory(c.models / "a.off");
  const IndexSummary summary = c.run();
  CHECK(counts(summary) == Counts{0, 0, 0, 1, 0, 0});
  CHECK(c.record("a.off")->failure == FailureKind::unreadable);
  CHECK_THAT(c.record("a.off")->reason, Contains("directory"));
  fs::remove(c.models / "a.off");
  c.write("a.off", "A");
  CHECK(counts(c.run()) == Counts{1, 0, 0, 0, 0, 0});
}

TEST_CASE("a file that vanishes during a run does no harm") {
  Collection c;
  c.write("a.off", "A");
  c.write("b.off", "BB");
  c.run();
  c.write("a.off", "changed");
  const Discovery found = discover(std::vector{c.models});
  fs::remove(c.models / "a.off");
  const DescribeFunction unused = [](const auto&) { return ShapeDescription{}; };
  const IndexSummary summary = run_index(found, {}, unused, *c.store, c.observer);
  CHECK(counts(summary) == Counts{0, 1, 0, 1, 0, 0});
  CHECK(c.record("a.off")->status == ShapeStatus::indexed);
  CHECK(c.record("a.off")->scale == 2.0);
}

TEST_CASE("an interrupted run stores what was in flight and can be continued") {
  Collection c;
  for (int i = 0; i < 6; ++i) c.write(std::to_string(i) + ".off", std::string(i, 'x'));
  c.interrupt_after = 2;
  IndexOptions options;
  options.prune = true;
  options.jobs = 2;
  const IndexSummary first = c.run(options);
  CHECK(first.is_interrupted);
  CHECK(first.indexed + first.left == 6);
  CHECK(first.indexed >= 2);
  CHECK(first.indexed <= 4);
  CHECK(c.store->shapes().size() == first.indexed);
  c.interrupt_after = 1000;
  const IndexSummary second = c.run(options);
  CHECK_FALSE(second.is_interrupted);
  CHECK(second.indexed == first.left);
  CHECK(second.unchanged == first.indexed);
}

TEST_CASE("a dry run tells what a run would do and does nothing") {
  Collection c;
  c.write("changed.off", "A");
  c.write("gone.off", "BB");
  c.write("moved.off", "CCC");
  c.write("same.off", "DDDD");
  c.run();
  c.write("changed.off", "changed");
  c.write("new.off", "new");
  fs::remove(c.models / "gone.off");
  fs::rename(c.models / "moved.off", c.models / "there.off");
  IndexOptions options;
  options.prune = true;
  c.is_dry_run = true;
  CHECK(counts(c.run(options)) == Counts{2, 1, 1, 0, 1, 0});
  CHECK(c.store->shapes().size() == 4);
  CHECK(c.record("moved.off"));
  c.is_dry_run = false;
  CHECK(counts(c.run(options)) == Counts{2, 1, 1, 0, 1, 0});
  CHECK(c.store->shapes().size() == 4);
}

TEST_CASE("a store that fails ends the run") {
  class FullStore final : public ShapeStore {
   public:
    const Recipe& recipe() const override { return recipe_; }
    std::vector<ShapeRecord> shapes() const override { return {}; }
    std::optional<ShapeRecord> find(std::int64_t) const override { return {}; }
    std::optional<ShapeRecord> find_by_path(const std::string&) const override { return {}; }
    std::vector<ShapeRecord> find_by_hash(const std::string&) const override { return {}; }
    std::int64_t put(const ShapeRecord&, const ShapeData&) override { throw StoreError("full"); }
    void touch(std::int64_t, std::uint64_t, std::int64_t) override {}
    void move(std::int64_t, const std::string&, std::int64_t) override {}
    void remove(std::int64_t) override {}
    void put_vector(std::int64_t, std::string_view, std::span<const float>) override {}
    ShapeData data(std::int64_t) const override { return {}; }
    std::vector<std::int64_t> shapes_without(std::string_view) const override { return {}; }
    VectorTable vectors(std::string_view) const override { return {}; }
    std::string revision() const override { return {}; }

   private:
    Recipe recipe_;
  };
  Collection c;
  c.write("a.off", "A");
  c.write("b.off", "BB");
  FullStore store;
  const DescribeFunction describe = [](const auto&) { return ShapeDescription{}; };
  CHECK_THROWS_AS(run_index(discover(std::vector{c.models}), {}, describe, store, c.observer),
                  StoreError);
}
