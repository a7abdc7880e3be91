#include <chrono>
#include <thread>
#include <utility>

#include <sqlite3.h>

#include "store/database_file.h"
#include "store/open_database.h"
#include "store/shape_store.h"
#include "store/sqlite_database.h"
#include "store/sqlite_diagnosis.h"
#include "store/sqlite_schema.h"
#include "store/sqlite_shape_store.h"

namespace mdbd {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw StoreError(path.string() + ": " + why);
}

// In write-ahead mode readers go on while a writer writes, and synchronous = FULL keeps a committed
// model through a loss of power; one wait for the disk is little beside a decomposition.
void enable_write_ahead_log(const Database& database) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + default_busy_timeout;
  while (true) {
    // The change of mode fails at once when another process does the same, busy timeout or not.
    try {
      Statement statement(database, "PRAGMA journal_mode = WAL");
      statement.step();
      if (statement.text(0) == "wal") break;
      refuse(database.path(), "its file system has no shared memory; put it on a local disk");
    } catch (const SqliteError& error) {
      if (error.code() != SQLITE_BUSY || Clock::now() >= deadline) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  database.execute("PRAGMA synchronous = FULL");
}

void require_same_recipe(const Database& database, const Recipe& asked) {
  const std::string difference = describe_difference(read_recipe(database), asked);
  if (difference.empty()) return;
  refuse(database.path(), "made with another recipe: " + difference +
                              "; use another file with --db, or the same options");
}

Database open_for_writing(const fs::path& path, const Recipe& recipe_if_new) {
  validate(recipe_if_new);
  if (!find_database_file(path)) require_folder_of(path);
  Database database(path, Access::read_write);
  require_whole_file(database);
  if (database.is_read_only()) throw StoreError(explain_read_only(path));
  prepare_schema(database, recipe_if_new);
  enable_write_ahead_log(database);
  return database;
}

}  // namespace

std::unique_ptr<ShapeStore> open_store(const fs::path& path, const std::optional<Recipe>& recipe) {
  Database database = open_for_writing(path, recipe.value_or(Recipe{}));
  if (recipe) require_same_recipe(database, *recipe);
  return std::make_unique<SqliteShapeStore>(std::move(database));
}

std::unique_ptr<ShapeStore> open_or_create_store(const fs::path& path,
                                                 const Recipe& recipe_if_new) {
  return std::make_unique<SqliteShapeStore>(open_for_writing(path, recipe_if_new));
}

std::unique_ptr<const ShapeStore> open_store_read_only(const fs::path& path) {
  return std::make_unique<SqliteShapeStore>(open_for_reading(path));
}

}  // namespace mdbd
