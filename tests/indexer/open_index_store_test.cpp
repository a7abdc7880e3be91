#include "indexer/open_index_store.h"

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Contains;

TEST_CASE("a new database gets the overrides, an existing one keeps its recipe") {
  test::TemporaryDirectory folder;
  const auto path = folder / "parts.db";
  CHECK(open_index_store(path, {.balls = 300, .radius_tolerance = {}}, false)->recipe().balls ==
        300);
  CHECK(open_index_store(path, {}, false)->recipe().balls == 300);
  CHECK(open_index_store(path, {.balls = 300, .radius_tolerance = 1e-3}, false)->recipe().balls ==
        300);
}

TEST_CASE("overrides must not contradict an existing database") {
  test::TemporaryDirectory folder;
  const auto path = folder / "parts.db";
  open_index_store(path, {}, false);
  const RecipeOverrides other{.balls = 300, .radius_tolerance = {}};
  for (const bool is_dry_run : {false, true}) {
    CHECK_THROWS_AS(open_index_store(path, other, is_dry_run), StoreError);
    CHECK_THROWS_WITH(open_index_store(path, other, is_dry_run),
                      Contains("balls") && Contains("300") && Contains("--db"));
  }
  CHECK_THROWS_AS(open_index_store(path, {.balls = 0, .radius_tolerance = {}}, false),
                  InvalidInput);
}

TEST_CASE("a dry run creates no database") {
  test::TemporaryDirectory folder;
  const auto store =
      open_index_store(folder / "parts.db", {.balls = 7, .radius_tolerance = {}}, true);
  CHECK(store->recipe().balls == 7);
  CHECK(store->shapes().empty());
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE(
    "an empty file, as a killed run may leave it, becomes a database of the recipe asked for") {
  const test::TemporaryDirectory folder;
  const std::filesystem::path path = folder.write("a.db", "");
  CHECK(open_index_store(path, {.balls = 20, .radius_tolerance = {}}, false)->recipe().balls == 20);
  CHECK(open_index_store(path, {}, false)->recipe().balls == 20);
}
