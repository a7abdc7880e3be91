#pragma once

#include <string>

#include "features/core/recipe.h"
#include "store/sqlite_database.h"

/// What is in a database of ours: application_id tells it apart from other SQLite databases,
/// user_version is the version of its schema.
namespace mdbd {

/// Creates the schema in a new database, with a recipe, or brings an older one up to date; all in
/// one transaction, so that neither a kill nor two processes at once leave half of it.
/// @throws StoreError if the database is foreign or of a newer schema; an older one is left as it
/// is
///         if read_recipe() throws
void prepare_schema(const Database& database, const Recipe& recipe_if_new);

/// Checks that a database can be read as it is; those of older schemas can.
/// @throws StoreError if it is foreign, empty, or of a newer schema than this program knows
void require_readable_schema(const Database& database);

/// As ShapeStore::revision(): triggers of the schema draw it at random with every change of a
/// vector, whoever makes it. Empty for schema 1.
std::string read_revision(const Database& database);

/// @throws StoreError if the recipe is damaged or of another version of the algorithm
Recipe read_recipe(const Database& database);

}  // namespace mdbd
