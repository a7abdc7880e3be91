#include "store/maintenance.h"

#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "store/shape_store.h"
#include "store/sqlite_database.h"
#include "tests/store/child_process.h"
#include "tests/store/models.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace fs = std::filesystem;

namespace {

constexpr std::size_t page_size = 4096;

void make_store(const fs::path& path, int models) {
  const auto store = open_store(path);
  for (int i = 0; i < models; ++i) {
    store->put(make_record("/" + std::to_string(i) + ".off"), make_data(i, 150));
  }
}

void overwrite_page(const fs::path& path, std::size_t page) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(static_cast<std::streamoff>(page * page_size));
  file << std::string(page_size, '\xff');
}

}  // namespace

TEST_CASE("a backup has what was there, whatever is written meanwhile, and no other name") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  store->put(make_record("/a.off"), make_data(1));
  backup_database(folder / "a.db", folder / "copy.db");
  store->put(make_record("/b.off"), make_data(2));
  const auto copy = open_store_read_only(folder / "copy.db");
  REQUIRE(copy->shapes().size() == 1);
  CHECK(is_same(copy->data(1), make_data(1)));
  CHECK(find_damage(folder / "copy.db").empty());
  CHECK_FALSE(std::filesystem::exists(folder / "copy.db.unfinished"));
  const auto reopened = open_store(folder / "copy.db");
  CHECK(reopened->put(make_record("/c.off"), make_data(3)) == 2);
}

TEST_CASE("a backup never replaces anything") {
  const TemporaryDirectory folder;
  open_store(folder / "a.db");
  folder.write("copy.db", "text");
  CHECK_THAT(store_error_of([&] { backup_database(folder / "a.db", folder / "copy.db"); }),
             Contains("copy.db: is there already"));
  CHECK_THAT(store_error_of([&] { backup_database(folder / "a.db", folder / "no/copy.db"); }),
             Contains("there is no folder"));
  CHECK_THAT(store_error_of([&] { backup_database(folder / "none.db", folder / "b.db"); }),
             Contains("there is no such database"));
}

TEST_CASE("compacting gives the space of removed models back and keeps the others") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  for (int i = 0; i < 50; ++i) {
    store->put(make_record("/" + std::to_string(i) + ".off"), make_data(i, 400));
  }
  for (std::int64_t id = 1; id < 50; ++id) store->remove(id);
  const DatabaseSize before = database_size(folder / "a.db");
  CHECK(before.unused_bytes > before.bytes / 2);
  compact_database(folder / "a.db");
  const DatabaseSize after = database_size(folder / "a.db");
  CHECK(after.unused_bytes == 0);
  CHECK(after.bytes < before.bytes / 4);
  CHECK(is_same(store->data(50), make_data(49, 400)));
}

TEST_CASE("compacting that a reader keeps from shrinking the file says so") {
  const TemporaryDirectory folder;
  make_store(folder / "a.db", 3);
  const Database reader(folder / "a.db", Access::read_only);
  const Transaction reading(reader, Transaction::Kind::reading);
  Statement(reader, "SELECT count(*) FROM shapes").step();
  CHECK_THAT(
      store_error_of([&] { compact_database(folder / "a.db", std::chrono::milliseconds(50)); }),
      StartsWith((folder / "a.db").string() + ": ") && Contains("in use"));
}

TEST_CASE("a database in a read-only folder can be looked after as far as it is only read") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "sub" / "a.db";
  const fs::path copies = folder / "copies";
  fs::create_directory(path.parent_path());
  fs::create_directory(copies);
  make_store(path, 1);
  open_to_all(folder.path(), fs::perms::owner_all);
  open_to_all(path, fs::perms::owner_read);
  open_to_all(path.parent_path(), fs::perms::owner_read | fs::perms::owner_exec);
  fs::permissions(copies, fs::perms::all);
  CHECK(run_unprivileged([&] {
          return store_error_of([&] {
            database_size(path);
            find_damage(path);
            backup_database(path, copies / "b.db");
          });
        }).empty());
  CHECK_THAT(run_unprivileged([&] { return store_error_of([&] { compact_database(path); }); }),
             StartsWith(path.string()) && Contains("is read-only"));
  fs::permissions(path.parent_path(), fs::perms::owner_all);
  CHECK(open_store_read_only(copies / "b.db")->shapes().size() == 1);
}

TEST_CASE("what is found of the damage is told, whatever SQLite cannot read after it") {
  const TemporaryDirectory folder;
  make_store(folder / "whole.db", 12);
  const std::size_t pages = fs::file_size(folder / "whole.db") / page_size;
  for (std::size_t page = 1; page < pages; ++page) {
    fs::copy_file(folder / "whole.db", folder / "a.db", fs::copy_options::overwrite_existing);
    overwrite_page(folder / "a.db", page);
    INFO("page " << page << " of " << pages);
    CHECK_FALSE(find_damage(folder / "a.db").empty());
  }
}

TEST_CASE("damaged pages and rows without a model are found") {
  const TemporaryDirectory folder;
  {
    const auto store = open_store(folder / "a.db");
    store->put(make_record("/a.off"), make_data(1));
  }
  CHECK(find_damage(folder / "a.db").empty());
  const Database database(folder / "a.db", Access::read_write);
  database.execute("PRAGMA foreign_keys = OFF; DELETE FROM shapes");
  CHECK(find_damage(folder / "a.db").size() == 4);  // two vectors, the balls, the picture
}
