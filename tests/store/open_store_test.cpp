#include <filesystem>

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

Recipe make_recipe(int balls) {
  Recipe recipe;
  recipe.balls = balls;
  return recipe;
}

void make_store_with_one_model(const fs::path& path) {
  open_store(path)->put(make_record("/a.off"), make_data(1));
}

std::size_t count_entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// Opens for writing and for reading: both must refuse, name the path and say the same thing.
void check_both_refuse(const fs::path& path, const std::string& words) {
  const std::string writing = store_error_of([&] { open_store(path); });
  CHECK_THAT(writing, StartsWith(path.string() + ": ") && Contains(words));
  const std::string reading = store_error_of([&] { open_store_read_only(path); });
  CHECK_THAT(reading, StartsWith(path.string() + ": ") && Contains(words));
}

}  // namespace

TEST_CASE("a new database gets the recipe asked for, or the default one") {
  const TemporaryDirectory folder;
  CHECK(open_store(folder / "a.db")->recipe() == Recipe{});
  CHECK(open_store(folder / "b.db", make_recipe(300))->recipe() == make_recipe(300));
  CHECK(open_store(folder / "b.db")->recipe() == make_recipe(300));
  CHECK(open_store_read_only(folder / "b.db")->recipe() == make_recipe(300));
  CHECK_NOTHROW(open_store(folder / "b.db", make_recipe(300)));
}

TEST_CASE("another recipe is refused and named") {
  const TemporaryDirectory folder;
  open_store(folder / "a.db", make_recipe(500));
  const std::string message =
      store_error_of([&] { open_store(folder / "a.db", make_recipe(300)); });
  CHECK_THAT(message, StartsWith((folder / "a.db").string()) &&
                          Contains("another recipe: balls 500 against 300") && Contains("--db"));
  CHECK(open_store(folder / "a.db")->recipe() == make_recipe(500));
}

TEST_CASE("a recipe out of range makes no database") {
  const TemporaryDirectory folder;
  CHECK_THROWS_AS(open_store(folder / "a.db", make_recipe(0)), InvalidInput);
  CHECK_FALSE(fs::exists(folder / "a.db"));
}

TEST_CASE("an empty file is a new database") {
  const TemporaryDirectory folder;
  const fs::path path = folder.write("a.db", "");
  CHECK_THAT(store_error_of([&] { open_store_read_only(path); }),
             StartsWith(path.string()) && Contains("run mdbd-index"));
  make_store_with_one_model(path);
  CHECK(open_store_read_only(path)->shapes().size() == 1);
}

TEST_CASE("closing leaves one file, whether written or read last") {
  const TemporaryDirectory folder;
  make_store_with_one_model(folder / "a.db");
  CHECK(count_entries(folder.path()) == 1);
  open_store_read_only(folder / "a.db")->shapes();
  CHECK(count_entries(folder.path()) == 1);
}

TEST_CASE("reading a database that is missing creates nothing") {
  const TemporaryDirectory folder;
  CHECK_THAT(store_error_of([&] { open_store_read_only(folder / "a.db"); }),
             StartsWith((folder / "a.db").string()) && Contains("no such database") &&
                 Contains("mdbd-index"));
  CHECK(count_entries(folder.path()) == 0);
}

TEST_CASE("a folder that is missing is named") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "x" / "a.db";
  CHECK_THAT(store_error_of([&] { open_store(path); }),
             StartsWith(path.string()) && Contains("no folder " + (folder / "x").string()));
  CHECK_FALSE(fs::exists(folder / "x"));
  folder.write("file", "");
  CHECK_THAT(store_error_of([&] { open_store(folder / "file" / "a.db"); }), Contains("no folder"));
  CHECK_THAT(store_error_of([&] { open_store(""); }), Contains("--db"));
}

TEST_CASE("what is no file is refused") {
  const TemporaryDirectory folder;
  check_both_refuse(folder.path(), "a folder");
  check_both_refuse("/dev/null", "no regular file");
}

TEST_CASE("a file that is no database is refused and kept") {
  const TemporaryDirectory folder;
  const std::string content = GENERATE(std::string("x"), std::string("OFF\n8 6 0\n"),
                                       std::string(10'000, '\0'), std::string(10'000, 'S'));
  const fs::path path = folder.write("a.db", content);
  check_both_refuse(path, "no database");
  CHECK(fs::file_size(path) == content.size());
}

TEST_CASE("a database of another program is refused and kept") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "a.db";
  Database(path, Access::read_write)
      .execute(GENERATE("CREATE TABLE photos (id)", "PRAGMA application_id = 252006674",
                        "PRAGMA user_version = 1"));
  check_both_refuse(path, "a database of another program");
  const Database database(path, Access::read_only);
  Statement mode(database, "PRAGMA journal_mode");
  mode.step();
  CHECK(mode.text(0) == "delete");
}

TEST_CASE("a database of another version of the algorithm is refused") {
  const TemporaryDirectory folder;
  make_store_with_one_model(folder / "a.db");
  Database(folder / "a.db", Access::read_write)
      .execute("UPDATE recipe SET value = '99' WHERE name = 'algorithm_version'");
  check_both_refuse(folder / "a.db", "made by version 99 of the algorithm");
}

TEST_CASE("a database of a newer schema is refused") {
  const TemporaryDirectory folder;
  make_store_with_one_model(folder / "a.db");
  Database(folder / "a.db", Access::read_write).execute("PRAGMA user_version = 7");
  check_both_refuse(folder / "a.db", "made by a newer mdbd (schema 7; this one knows 2); update");
}

TEST_CASE("the tables and triggers of schema 2 are these") {
  const TemporaryDirectory folder;
  open_store(folder / "a.db");
  const Database database(folder / "a.db", Access::read_only);
  Statement row(database,
                "SELECT group_concat(name, ' ') FROM (SELECT name FROM sqlite_schema"
                " WHERE name NOT LIKE 'sqlite%' ORDER BY name)");
  REQUIRE(row.step());
  CHECK(row.text(0) ==
        "balls recipe revision shape_deleted shape_updated shapes shapes_by_content"
        " thumbnails vector_deleted vector_inserted vector_updated vectors");
}

TEST_CASE("a database in a read-only folder can be read, not written") {
  const TemporaryDirectory folder;
  const fs::path path = folder / "sub ?%" / "a.db";
  fs::create_directory(path.parent_path());
  make_store_with_one_model(path);
  open_to_all(folder.path(), fs::perms::owner_all);
  open_to_all(path, fs::perms::owner_read);
  open_to_all(path.parent_path(), fs::perms::owner_read | fs::perms::owner_exec);

  CHECK(run_unprivileged([&] {
          const auto store = open_store_read_only(path);
          return is_same(store->data(1), make_data(1)) ? "read" : "differs";
        }) == "read");
  CHECK_THAT(run_unprivileged([&] { return store_error_of([&] { open_store(path); }); }),
             StartsWith(path.string()) && Contains("the file is read-only") && Contains("--db"));

  fs::permissions(path, fs::perms::all);
  CHECK(run_unprivileged(
            [&] { return std::to_string(open_store_read_only(path)->shapes().size()); }) == "1");
  CHECK_THAT(run_unprivileged([&] { return store_error_of([&] { open_store(path); }); }),
             StartsWith(path.string()) && Contains("the folder") && Contains("is read-only"));
  CHECK_THAT(run_unprivileged([&] {
               return store_error_of([&] { open_store(path.parent_path() / "new.db"); });
             }),
             Contains("new.db: ") && Contains("the folder") && Contains("is read-only"));
  CHECK(count_entries(path.parent_path()) == 1);
  fs::permissions(path.parent_path(), fs::perms::owner_all);
}

TEST_CASE("changes in a log that cannot be read are not passed over in silence") {
  const TemporaryDirectory folder;
  const fs::path place = folder / "place";
  fs::create_directory(place);
  {
    const auto store = open_store(folder / "a.db");
    store->put(make_record("/a.off"), make_data(1));
    fs::copy(folder / "a.db", place / "a.db");
    fs::copy(folder / "a.db-wal", place / "a.db-wal");
  }
  open_to_all(folder.path(), fs::perms::owner_all);
  open_to_all(place, fs::perms::owner_read | fs::perms::owner_exec);
  const auto read = [&] { return store_error_of([&] { open_store_read_only(place / "a.db"); }); };
  CHECK_THAT(run_unprivileged(read), StartsWith((place / "a.db").string()) &&
                                         Contains("a.db-wal") && Contains("mdbd-index"));
  fs::permissions(place, fs::perms::owner_all);
  CHECK(open_store_read_only(place / "a.db")->shapes().size() == 1);
}

TEST_CASE("a database that may not be read says so") {
  const TemporaryDirectory folder;
  make_store_with_one_model(folder / "a.db");
  open_to_all(folder.path(), fs::perms::owner_all);
  fs::permissions(folder / "a.db", fs::perms::none);
  const auto read = [&] { return store_error_of([&] { open_store_read_only(folder / "a.db"); }); };
  const auto write = [&] { return store_error_of([&] { open_store(folder / "a.db"); }); };
  CHECK_THAT(run_unprivileged(read), Contains("a.db: no permission to read it"));
  CHECK_THAT(run_unprivileged(write), Contains("a.db: no permission to read it"));
  fs::permissions(folder.path(), fs::perms::none);
  CHECK_THAT(run_unprivileged(read), Contains("a.db: no permission to enter its folder"));
  fs::permissions(folder.path(), fs::perms::owner_all);
}
