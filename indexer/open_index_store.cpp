#include "indexer/open_index_store.h"

#include <fmt/format.h>

#include "cli/terminal.h"
#include "features/core/errors.h"
#include "indexer/dry_run_store.h"

namespace mdbd {
namespace {

Recipe with_overrides(Recipe recipe, const RecipeOverrides& overrides) {
  recipe.balls = overrides.balls.value_or(recipe.balls);
  recipe.radius_tolerance = overrides.radius_tolerance.value_or(recipe.radius_tolerance);
  recipe.denoise = overrides.denoise.value_or(recipe.denoise);
  recipe.solidify = overrides.solidify.value_or(recipe.solidify);
  validate(recipe);
  return recipe;
}

/// Refuses what contradicts an existing database, and tells the way out.
void require_same_recipe(const std::filesystem::path& database, const Recipe& recipe,
                         const RecipeOverrides& overrides) {
  const Recipe wanted = with_overrides(recipe, overrides);
  if (wanted == recipe) return;
  throw StoreError(fmt::format(
      "{} was built with another recipe: {}. Leave out the option to add to it, or name another "
      "database with --db",
      printable(database.string()), describe_difference(recipe, wanted)));
}

}  // namespace

std::unique_ptr<ShapeStore> open_index_store(const std::filesystem::path& database,
                                             const RecipeOverrides& overrides, bool is_dry_run) {
  std::error_code ignored;
  const Recipe recipe_if_new = with_overrides({}, overrides);
  if (is_dry_run) {
    if (std::filesystem::status(database, ignored).type() ==
        std::filesystem::file_type::not_found) {
      return std::make_unique<DryRunStore>(nullptr, recipe_if_new);
    }
    auto store = open_store_read_only(database);
    const Recipe recipe = store->recipe();
    require_same_recipe(database, recipe, overrides);
    return std::make_unique<DryRunStore>(std::move(store), recipe);
  }
  auto store = open_or_create_store(database, recipe_if_new);
  require_same_recipe(database, store->recipe(), overrides);
  return store;
}

}  // namespace mdbd
