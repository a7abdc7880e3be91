#pragma once

#include <string>

#include "store/maintenance.h"
#include "store/shape_store.h"

namespace mdbd {

/// What is in a database, for people: models by state and format, signatures, space, recipe.
std::string describe_database(const ShapeStore& store, const DatabaseSize& size);

}  // namespace mdbd
