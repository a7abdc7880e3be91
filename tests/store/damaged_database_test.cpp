#include <fstream>
#include <iterator>
#include <random>

#include <catch2/catch.hpp>

#include "store/shape_store.h"
#include "store/sqlite_database.h"
#include "tests/store/models.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace fs = std::filesystem;

namespace {

constexpr int model_count = 12;

void make_store(const fs::path& path) {
  const auto store = open_store(path);
  for (int i = 0; i < model_count; ++i) {
    store->put(make_record("/" + std::to_string(i) + ".off"), make_data(i, 150));
  }
}

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Uses all of a store. Anything but success and StoreError ends the test.
std::string use(const fs::path& path) {
  return store_error_of([&] {
    open_store_read_only(path)->vectors(signature_mdbd_100);
    const auto store = open_store(path);
    for (const ShapeRecord& record : store->shapes()) {
      store->data(record.id);
      store->find_by_hash(record.content_hash);
    }
    store->put(make_record("/new.off"), make_data(1));
    store->put(make_record("/3.off"), make_data(2));
  });
}

// What reading the one model of a database says after a statement has changed it.
std::string error_after(const fs::path& path, const std::string& sql) {
  open_store(path)->put(make_record("/a.off"), make_data(1));
  Database(path, Access::read_write).execute(sql);
  return store_error_of([&] {
    const auto store = open_store(path);
    store->vectors(signature_mdbd_100);
    for (const ShapeRecord& record : store->shapes()) store->data(record.id);
  });
}

}  // namespace

TEST_CASE("a truncated database is refused at every length") {
  const TemporaryDirectory folder;
  make_store(folder / "whole.db");
  const std::string whole = read_file(folder / "whole.db");
  REQUIRE(whole.size() > 50'000);
  for (std::size_t length :
       {std::size_t{1}, std::size_t{15}, std::size_t{16}, std::size_t{50}, std::size_t{99},
        std::size_t{100}, std::size_t{101}, std::size_t{511}, std::size_t{512}, std::size_t{1024},
        std::size_t{4095}, std::size_t{4096}, std::size_t{4097}, std::size_t{8192},
        std::size_t{30'000}, whole.size() / 2, whole.size() - 4096, whole.size() - 1}) {
    INFO("length " << length);
    const fs::path path = folder.write("a.db", whole.substr(0, length));
    CHECK_THAT(use(path), StartsWith(path.string() + ": "));
    CHECK(fs::file_size(path) == length);
    CHECK_THAT(use(path), Contains(length < 15 ? "no database" : "truncated, "));
  }
}

TEST_CASE("flipped bytes give an error or results, never a crash") {
  const TemporaryDirectory folder;
  make_store(folder / "whole.db");
  const std::string whole = read_file(folder / "whole.db");
  std::mt19937 random(7);
  int errors = 0;
  for (int run = 0; run < 150; ++run) {
    std::string damaged = whole;
    // Every third run strikes the header and the schema, where there are few bytes and much to
    // break.
    const std::size_t range = run % 3 == 0 ? 4096 : damaged.size();
    for (int i = 0; i < 1 + run % 20; ++i) damaged[random() % range] = static_cast<char>(random());
    const fs::path path = folder.write("a.db", damaged);
    const std::string message = use(path);
    INFO("run " << run << ": " << message);
    if (!message.empty()) {
      CHECK_THAT(message, StartsWith(path.string() + ": "));
      ++errors;
    }
    for (const char* ending : {"-wal", "-shm", "-journal"}) fs::remove(path.string() + ending);
  }
  CHECK(errors > 15);
}

TEST_CASE("overwritten pages give an error or results, never a crash") {
  const TemporaryDirectory folder;
  make_store(folder / "whole.db");
  const std::string whole = read_file(folder / "whole.db");
  for (std::size_t page = 0; page < whole.size() / 4096; ++page) {
    std::string damaged = whole;
    damaged.replace(page * 4096, 4096, 4096, static_cast<char>(page % 2 == 0 ? 0 : 0xff));
    const fs::path path = folder.write("a.db", damaged);
    const std::string message = use(path);
    INFO("page " << page << ": " << message);
    if (!message.empty()) CHECK_THAT(message, StartsWith(path.string() + ": "));
    for (const char* ending : {"-wal", "-shm", "-journal"}) fs::remove(path.string() + ending);
  }
}

TEST_CASE("damaged content names the model and what is damaged") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "a.db";
  CHECK_THAT(error_after(path, "UPDATE vectors SET \"values\" = x'00112233'"),
             StartsWith(path.string()) && Contains("vector of /a.off: 4 bytes instead of 400"));
  CHECK_THAT(
      error_after(
          path,
          "UPDATE vectors SET \"values\" = CAST(x'0000c07f' || substr(\"values\", 5) AS BLOB)"),
      Contains("vector of /a.off"));
  CHECK_THAT(error_after(path, "DELETE FROM vectors"), Contains("vector of /a.off: 0 bytes"));
  CHECK_THAT(error_after(path, "UPDATE balls SET \"values\" = x'00'"),
             Contains("balls of /a.off: 1 bytes"));
  CHECK_THAT(
      error_after(
          path, "UPDATE balls SET \"values\" = CAST(x'000000000000f87f' || zeroblob(24) AS BLOB)"),
      Contains("balls of /a.off"));
  CHECK_THAT(error_after(path, "UPDATE shapes SET status = 'maybe'"), Contains("status of /a.off"));
  CHECK_THAT(error_after(path, "UPDATE shapes SET failure = ''"), Contains("status of /a.off"));
}

TEST_CASE("a damaged recipe or schema is refused") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "a.db";
  const std::string sql =
      GENERATE("DELETE FROM recipe WHERE name = 'balls'",
               "UPDATE recipe SET value = '-1' WHERE name = 'balls'",
               "UPDATE recipe SET value = 'x' WHERE name = 'balls'",
               "INSERT INTO recipe VALUES ('colour', 'red')", "DROP TABLE recipe",
               "DROP TABLE shapes", "PRAGMA user_version = 0", "PRAGMA user_version = -1");
  CHECK_THAT(error_after(path, sql), StartsWith(path.string() + ": damaged ("));
}
