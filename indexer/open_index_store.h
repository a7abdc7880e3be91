#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "store/shape_store.h"

namespace mdbd {

/// Parameters of the recipe that were asked for explicitly.
struct RecipeOverrides {
  std::optional<int> balls;
  std::optional<double> radius_tolerance;
  std::optional<std::string> denoise = {};
  std::optional<std::string> solidify = {};
};

/// Opens the database of an index run. A new one gets the default recipe with the overrides; an
/// existing one keeps its own, which the overrides must not contradict.
/// @param is_dry_run nothing is created, and nothing that is written to the store is kept
/// @throws StoreError if the database has another recipe, and as open_store()
/// @throws InvalidInput if an override is out of range
std::unique_ptr<ShapeStore> open_index_store(const std::filesystem::path& database,
                                             const RecipeOverrides& overrides, bool is_dry_run);

}  // namespace mdbd
