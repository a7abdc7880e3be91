#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "features/core/signature.h"
#include "query/collection_filter.h"
#include "store/shape_store.h"

namespace mdbd {

/// The vector of an indexed model, computed from its balls if the database is older than the
/// signature.
/// @throws StoreError if there is no such model or it cannot be read
std::vector<float> stored_vector(const ShapeStore& store, std::int64_t id, SignatureKind signature);

/// R in a unit of length.
/// @param statistics of the model; if they tell no unit, R is taken to be in it already
/// @param unit one of length_units, or empty: R stays as it is
double scale_in_unit(double scale, const std::string& statistics, const std::string& unit);

/// The vectors of all indexed models that pass a filter, their scales in a unit as
/// scale_in_unit().
/// @param completed counts up those whose vector had to be computed from their balls
/// @throws StoreError if the collection cannot be read
VectorTable collect_vectors(const ShapeStore& store, SignatureKind signature,
                            const CollectionFilter& filter, const std::string& unit,
                            std::size_t& completed);

/// The rows of a table that pass a filter.
VectorTable select_vectors(const VectorTable& table, const CollectionFilter& filter);

}  // namespace mdbd
