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
CREATE TABLE revision (
  stamp BLOB NOT NULL
) STRICT;
INSERT INTO revision (stamp) VALUES (randomblob(16));

CREATE TRIGGER vector_inserted AFTER INSERT ON vectors
  BEGIN UPDATE revision SET stamp = randomblob(16); END;
CREATE TRIGGER vector_updated AFTER UPDATE ON vectors
  BEGIN UPDATE revision SET stamp = randomblob(16); END;
CREATE TRIGGER vector_deleted AFTER DELETE ON vectors
  BEGIN UPDATE revision SET stamp = randomblob(16); END;
CREATE TRIGGER shape_updated AFTER UPDATE OF path, scale, status ON shapes
  BEGIN UPDATE revision SET stamp = randomblob(16); END;
CREATE TRIGGER shape_deleted AFTER DELETE ON shapes
  BEGIN UPDATE revision SET stamp = randomblob(16); END;

CREATE TABLE thumbnails (
  shape_id INTEGER PRIMARY KEY REFERENCES shapes (id) ON DELETE CASCADE,
  png BLOB NOT NULL
) STRICT;
)"};
constexpr std::int64_t known_schema = migrations.size();
constexpr std::int64_t first_schema_with_revision = 2;

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

// Recipes of other versions have other parameters, too.
void require_same_algorithm(const Database& database, const RecipeEntries& entries) {
  const std::string current = std::to_string(current_algorithm_version);
  for (const auto& [name, value] : entries) {
    if (name != "algorithm_version" || value == current) continue;
    refuse(database, "made by version " + value + " of the algorithm, and this mdbd has version " +
                         current + ", whose numbers differ; index again into another --db");
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
  if (schema > 0) read_recipe(database);  // what cannot be used is not touched
  for (std::int64_t i = schema; i < known_schema; ++i) database.execute(migrations[i]);
  if (schema == 0) {
    database.execute("PRAGMA application_id = " + std::to_string(application_id));
    write_recipe(database, recipe_if_new);
  }
  database.execute("PRAGMA user_version = " + std::to_string(known_schema));
  writing.commit();
}

void require_readable_schema(const Database& database) {
  const Transaction reading(database, Transaction::Kind::reading);
  if (read_schema(database) == 0) refuse(database, "empty; run mdbd-index on it first");
}

std::string read_revision(const Database& database) {
  const Transaction reading(database, Transaction::Kind::reading);
  if (read_schema(database) < first_schema_with_revision) return {};
  Statement statement(database, "SELECT hex(stamp) FROM revision");
  return statement.step() ? statement.text(0) : std::string();
}

Recipe read_recipe(const Database& database) {
  RecipeEntries entries;
  Statement statement(database, "SELECT name, value FROM recipe");
  while (statement.step()) entries.emplace_back(statement.text(0), statement.text(1));
  require_same_algorithm(database, entries);
  try {
    Recipe recipe = recipe_from_entries(entries);
    validate(recipe);
    return recipe;
  } catch (const InvalidInput& error) {
    throw StoreError(explain_damage(database.path(), error.what()));
  }
}

}  // namespace mdbd
