#include "store/sqlite_schema.h"

#include <array>

#include "store/sqlite_diagnosis.h"

namespace mdbd {
namespace {

constexpr std::int64_t application_id = 0x4D444244;  // "MDBD"

// Migration i leads from schema i to schema i + 1. What has been released is never changed.
constexpr std::array migrations = {R"(
CREATE TABLE recipe (
  name TEXT PRIMARY KEY,
  value TEXT NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE shapes (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  path TEXT NOT NULL UNIQUE,
  content_hash TEXT NOT NULL,
  file_size INTEGER NOT NULL,
  modified_ns INTEGER NOT NULL,
  format TEXT NOT NULL,
  representation TEXT NOT NULL,
  statistics TEXT NOT NULL,
  scale REAL NOT NULL,
  status TEXT NOT NULL,
  failure TEXT NOT NULL,
  reason TEXT NOT NULL,
  walk_is_defined INTEGER NOT NULL,
  seconds REAL NOT NULL,
  indexed_at TEXT NOT NULL
) STRICT;
CREATE INDEX shapes_by_content ON shapes (content_hash);

CREATE TABLE vectors (
  shape_id INTEGER NOT NULL REFERENCES shapes (id) ON DELETE CASCADE,
  signature TEXT NOT NULL,
  "values" BLOB NOT NULL,
  PRIMARY KEY (shape_id, signature)
) STRICT, WITHOUT ROWID;

CREATE TABLE balls (
  shape_id INTEGER PRIMARY KEY REFERENCES shapes (id) ON DELETE CASCADE,
  "values" BLOB NOT NULL
) STRICT;
)",
                                   R"(
CREATE TABLE thumbnails (
  shape_id INTEGER PRIMARY KEY REFERENCES shapes (id) ON DELETE CASCADE,
  png BLOB NOT NULL
) STRICT;
)"};
constexpr std::int64_t known_schema = migrations.size();

[[noreturn]] void refuse(const Database& database, const std::string& why) {
  throw StoreError(database.path().string() + ": " + why);
}

std::int64_t query_integer(const Database& database, std::string_view sql) {
  Statement statement(database, sql);
  statement.step();
  return statement.integer(0);
}

// The schema of a database of ours; 0 if nothing has been written to it yet.
std::int64_t read_schema(const Database& database) {
  const std::int64_t application = query_integer(database, "PRAGMA application_id");
  const std::int64_t schema = query_integer(database, "PRAGMA user_version");
  if (application == 0 && schema == 0 &&
      query_integer(database, "SELECT count(*) FROM sqlite_schema") == 0) {
    return 0;
  }
  if (application != application_id) {
    refuse(database, "a database of another program; name another file with --db");
  }
  if (schema > known_schema) {
    refuse(database, "made by a newer mdbd (schema " + std::to_string(schema) +
                         "; this one knows " + std::to_string(known_schema) +
                         "); update mdbd, or use another --db");
  }
  if (schema < 1) {
    throw StoreError(explain_damage(database.path(), "schema " + std::to_string(schema)));
  }
  return schema;
}

void write_recipe(const Database& database, const Recipe& recipe) {
  for (const auto& [name, value] : to_entries(recipe)) {
    Statement(database, "INSERT INTO recipe (name, value) VALUES (?, ?)")
        .bind(std::string_view(name), std::string_view(value))
        .run();
  }
}

}  // namespace

void prepare_schema(const Database& database, const Recipe& recipe_if_new) {
  {
    const Transaction reading(database, Transaction::Kind::reading);
    if (read_schema(database) == known_schema) return;
  }
  Transaction writing(database, Transaction::Kind::writing);
  // Another process may have been faster since.
  const std::int64_t schema = read_schema(database);
  for (std::int64_t i = schema; i < known_schema; ++i) database.execute(migrations[i]);
  if (schema == 0) {
    database.execute("PRAGMA application_id = " + std::to_string(application_id));
    write_recipe(database, recipe_if_new);
  }
  database.execute("PRAGMA user_version = " + std::to_string(known_schema));
  writing.commit();
}

void require_current_schema(const Database& database) {
  const Transaction reading(database, Transaction::Kind::reading);
  if (read_schema(database) != known_schema) {
    refuse(database, "empty, or made by an older mdbd; run mdbd-index on it first");
  }
}

Recipe read_recipe(const Database& database) {
  RecipeEntries entries;
  Statement statement(database, "SELECT name, value FROM recipe");
  while (statement.step()) entries.emplace_back(statement.text(0), statement.text(1));
  try {
    Recipe recipe = recipe_from_entries(entries);
    if (recipe.algorithm_version != current_algorithm_version) {
      refuse(database, "made by version " + std::to_string(recipe.algorithm_version) +
                           " of the algorithm, and this mdbd has version " +
                           std::to_string(current_algorithm_version) +
                           ", whose numbers differ; index again into another --db");
    }
    validate(recipe);
    return recipe;
  } catch (const InvalidInput& error) {
    throw StoreError(explain_damage(database.path(), error.what()));
  }
}

}  // namespace mdbd
