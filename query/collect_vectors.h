#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "features/core/signature.h"
#include "query/collection_filter.h"
#include "store/shape_store.h"

namespace mdbd {

/// The vector of an indexed model, computed from its balls if the database is older than the
/// signature.
/// @throws StoreError if there is no such model or it cannot be read
std::vector<float> stored_vector(const ShapeStore& store, std::int64_t id, SignatureKind signature);

/// The vectors of all indexed models that pass a filter.
/// @param completed counts up those whose vector had to be computed from their balls
/// @throws StoreError if the collection cannot be read
VectorTable collect_vectors(const ShapeStore& store, SignatureKind signature,
                            const CollectionFilter& filter, std::size_t& completed);

/// The rows of a table that pass a filter.
VectorTable select_vectors(const VectorTable& table, const CollectionFilter& filter);

}  // namespace mdbd
