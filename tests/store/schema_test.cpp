// Databases that earlier programs made. data/schema_1.db holds three models and a failed one, made
// by version 5 of the algorithm.
#include <filesystem>

#include <catch2/catch.hpp>

#include "store/maintenance.h"
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

/// A database of schema 1 that a version of the algorithm made.
fs::path copy_of_schema_1(const TemporaryDirectory& folder,
                          int algorithm_version = current_algorithm_version) {
  const fs::path path = folder / "old.db";
  fs::copy(fs::path(MDBD_TEST_DATA) / "schema_1.db", path);
  fs::permissions(path, fs::perms::owner_all);
  Database(path, Access::read_write)
      .execute("UPDATE recipe SET value = '" + std::to_string(algorithm_version) +
               "' WHERE name = 'algorithm_version'");
  return path;
}

std::int64_t schema_of(const fs::path& path) {
  const Database database(path, Access::read_only);
  Statement row(database, "PRAGMA user_version");
  row.step();
  return row.integer(0);
}

void check_contents(const ShapeStore& store) {
  CHECK(store.recipe().balls == 6);
  const std::vector<ShapeRecord> records = store.shapes();
  REQUIRE(records.size() == 4);
  CHECK(records[0].path == "/models/cube.off");
  CHECK(records[0].content_hash == "92856c10b6ad30db540c28aa34a9ee9d");
  CHECK(records[0].scale == Approx(std::sqrt(0.75)));
  CHECK(records[0].id == 3);
  CHECK(records[2].path == "/models/empty.ply");
  CHECK(records[2].failure == FailureKind::content);
  CHECK_THAT(records[2].reason, StartsWith("not a PLY file"));
  const ShapeData cube = store.data(3);
  REQUIRE(cube.balls.size() == 6);
  CHECK(cube.balls[0].radius == Approx(0.5));
  CHECK(cube.signature.size() == 100);
  CHECK(cube.signature[0] == Approx(0.5 / std::sqrt(0.75)));
  CHECK(cube.fused.size() == 312);
  CHECK(store.vectors(signature_mdbd_100).size() == 3);
  CHECK(store.shapes_without(stored_mdbd_fused).empty());
}

}  // namespace

TEST_CASE("a database of schema 1 is read as it is") {
  const TemporaryDirectory folder;
  const fs::path path = copy_of_schema_1(folder);
  check_contents(*open_store_read_only(path));
  CHECK(open_store_read_only(path)->revision().empty());
  CHECK(find_damage(path).empty());
  CHECK(schema_of(path) == 1);
}

TEST_CASE("a database of schema 1 that is opened for writing is brought up to date") {
  const TemporaryDirectory folder;
  const fs::path path = copy_of_schema_1(folder);
  std::string revision;
  {
    const auto store = open_store(path);
    check_contents(*store);
    revision = store->revision();
    CHECK_FALSE(revision.empty());
    store->put(make_record("/new.off"), make_data(1));
    CHECK(store->revision() != revision);
    store->remove(store->find_by_path("/new.off")->id);
  }
  CHECK(schema_of(path) == 2);
  CHECK(find_damage(path).empty());
  check_contents(*open_store_read_only(path));
}

TEST_CASE("a backup of a database of schema 1 is one, and can be brought up to date") {
  const TemporaryDirectory folder;
  backup_database(copy_of_schema_1(folder), folder / "copy.db");
  CHECK(schema_of(folder / "copy.db") == 1);
  check_contents(*open_store(folder / "copy.db"));
}

// Versions 1 and 2 of the algorithm knew neither denoising nor sheets, 3 and 4 no sheets.
TEST_CASE("a database of an earlier version of the algorithm is refused by name and kept") {
  const TemporaryDirectory folder;
  const int version = GENERATE(1, 2, 3, 4, 5);
  const fs::path path = copy_of_schema_1(folder, version);
  if (version < 5) {
    Database(path, Access::read_write)
        .execute("DELETE FROM recipe WHERE name = 'solidify'" +
                 std::string(version < 3 ? " OR name = 'denoise'" : ""));
  }
  const std::string words =
      "made by version " + std::to_string(version) + " of the algorithm, and this mdbd has";
  CHECK_THAT(store_error_of([&] { open_store_read_only(path); }),
             StartsWith(path.string()) && Contains(words) && Contains("another --db"));
  CHECK_THAT(store_error_of([&] { open_store(path); }), Contains(words));
  CHECK(schema_of(path) == 1);
  const Database database(path, Access::read_only);
  Statement count(database, "SELECT count(*) FROM vectors");
  REQUIRE(count.step());
  CHECK(count.integer(0) == 6);
}
