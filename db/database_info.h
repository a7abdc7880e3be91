#pragma once

#include <filesystem>
#include <string>

#include "store/maintenance.h"
#include "store/shape_store.h"

namespace mdbd {

/// What is in a database, for people: models by state and format, signatures, space, recipe.
std::string describe_database(const ShapeStore& store, const DatabaseSize& size);

/// The files beside a database from which mdbd-query reads vectors, a line each, for people.
std::string describe_caches(const std::filesystem::path& database);

}  // namespace mdbd
