#pragma once

#include "features/core/recipe.h"
#include "store/sqlite_database.h"

/// What is in a database of ours: application_id tells it apart from other SQLite databases,
/// user_version is the version of its schema.
namespace mdbd {

/// Creates the schema in a new database, with a recipe, or brings an older one up to date; all in
/// one transaction, so that neither a kill nor two processes at once leave half of it.
/// @throws StoreError if the database is foreign or of a newer schema
void prepare_schema(const Database& database, const Recipe& recipe_if_new);

/// Checks that a database can be read as it is.
/// @throws StoreError if it is foreign, empty, or of another schema than this program knows
void require_current_schema(const Database& database);

/// @throws StoreError if the recipe is damaged
Recipe read_recipe(const Database& database);

}  // namespace mdbd
