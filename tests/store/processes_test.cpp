#include <algorithm>
#include <filesystem>
#include <memory>

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "store/shape_store.h"
#include "tests/store/child_process.h"
#include "tests/store/models.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Matchers::Contains;

namespace fs = std::filesystem;

namespace {

constexpr int path_count = 7;

// The hash says which data belongs to the record.
void put_model(ShapeStore& store, int seed) {
  const std::string path = "/" + std::to_string(seed % path_count) + ".off";
  store.put(make_record(path, std::to_string(seed)), make_data(seed, 100 + seed % 50));
}

bool is_whole(const ShapeStore& store, const ShapeRecord& record) {
  const int seed = std::stoi(record.content_hash);
  return record.path == "/" + std::to_string(seed % path_count) + ".off" &&
         is_same(store.data(record.id), make_data(seed, 100 + seed % 50));
}

}  // namespace

TEST_CASE("processes that create a database at once all succeed") {
  const TemporaryDirectory folder;
  for (int round = 0; round < 10; ++round) {
    const fs::path path = folder / (std::to_string(round) + ".db");
    const fs::path gate = folder / (std::to_string(round) + ".gate");
    std::vector<std::unique_ptr<ChildProcess>> children;
    children.reserve(4);
    for (int i = 0; i < 4; ++i) {
      children.push_back(std::make_unique<ChildProcess>([=](int output) {
        while (!fs::exists(gate)) usleep(50);
        open_store(path, Recipe{})->put(make_record("/" + std::to_string(i)), make_data(i));
        write_text(output, "done");
      }));
    }
    folder.write(gate.filename().string(), "");
    for (const auto& child : children) CHECK(child->read_all() == "done");
    CHECK(open_store_read_only(path)->vectors(signature_mdbd_100).size() == 4);
  }
}

TEST_CASE("of two processes with different recipes the later one is refused") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "a.db";
  const auto create = [&](int balls) {
    return [path, balls](int output) {
      Recipe recipe;
      recipe.balls = balls;
      write_text(output, std::to_string(open_store(path, recipe)->recipe().balls));
    };
  };
  ChildProcess first(create(300));
  ChildProcess second(create(400));
  const std::string results = first.read_all() + "|" + second.read_all();
  const int balls = open_store_read_only(path)->recipe().balls;
  CHECK((balls == 300 || balls == 400));
  CHECK_THAT(results, Contains("another recipe: balls") && Contains(std::to_string(balls)));
}

TEST_CASE("a killed writer leaves whole models and all that it committed") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "a.db";
  for (std::size_t run = 0; run < 8; ++run) {
    const std::size_t committed = 20 + 13 * run;
    {
      ChildProcess writer([&](int output) {
        const auto store = open_store(path);
        for (int seed = 0;; ++seed) {
          put_model(*store, seed);
          write_text(output, ".");
        }
      });
      REQUIRE(writer.read_bytes(committed) == std::string(committed, '.'));
    }
    const bool is_reader_first = run % 2 == 0;
    const std::shared_ptr<const ShapeStore> store =
        is_reader_first ? std::shared_ptr<const ShapeStore>(open_store_read_only(path))
                        : std::shared_ptr<const ShapeStore>(open_store(path));
    const std::vector<ShapeRecord> records = store->shapes();
    REQUIRE(records.size() == path_count);
    std::size_t last = 0;
    for (const ShapeRecord& record : records) {
      CHECK(is_whole(*store, record));
      last = std::max(last, static_cast<std::size_t>(std::stoi(record.content_hash)));
    }
    CHECK(last + 1 >= committed);
  }
}

TEST_CASE("readers work on whole models while another process writes") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "a.db";
  ChildProcess writer([&](int output) {
    const auto store = open_store(path);
    for (int seed = 0; seed < 400; ++seed) {
      put_model(*store, seed);
      if (seed == path_count) write_text(output, "+");
    }
    write_text(output, "done");
  });
  REQUIRE(writer.read_bytes(1) == "+");
  const auto store = open_store_read_only(path);
  for (int i = 0; i < 20; ++i) {
    const VectorTable vectors = store->vectors(signature_mdbd_100);
    REQUIRE(vectors.size() == path_count);
    for (const StoredVector vector : vectors) {
      const int seed = static_cast<int>(vector.values[0]);
      CHECK(vector.path == "/" + std::to_string(seed % path_count) + ".off");
      CHECK(numbers(vector) == make_data(seed).signature);
    }
  }
  CHECK(writer.read_all() == "done");
}

TEST_CASE("a writer whose file may not grow stops with a message and loses nothing") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "a.db";
  ChildProcess writer([&](int output) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1'000'000, 1'000'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const auto store = open_store(path);
    int stored = 0;
    const std::string error = store_error_of([&] {
      for (int seed = 0; seed < 10'000; ++seed) {
        store->put(make_record("/" + std::to_string(seed)), make_data(seed));
        ++stored;
      }
    });
    const bool is_whole = store->shapes().size() == static_cast<std::size_t>(stored);
    write_text(output, std::to_string(stored) + (is_whole ? " kept, " : " stored, ") + error);
  });
  const std::string report = writer.read_all();
  CHECK_THAT(report, Contains(" kept, " + path.string() + ": reading or writing failed"));
  const int stored = std::stoi(report);
  REQUIRE(stored > 10);
  const auto store = open_store(path);
  CHECK(store->shapes().size() == static_cast<std::size_t>(stored));
  CHECK(is_same(store->data(store->find_by_path("/10")->id), make_data(10)));
  store->put(make_record("/more"), make_data(1));
}
