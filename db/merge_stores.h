#pragma once

#include <cstddef>

#include "store/shape_store.h"

namespace mdbd {

/// What became of the models of a database that was merged into another.
struct MergeSummary {
  std::size_t added = 0;
  std::size_t replaced = 0;  ///< the target had an older one, or one that failed
  std::size_t kept = 0;      ///< the target's was left as it is
};

/// Takes over the models of a database. Where both have a path, an indexed model goes before a
/// failed one, and else the one of the file that was changed last. Each model is taken over as a
/// whole or not at all; to merge again after an interruption continues.
/// @throws StoreError if the recipes differ, or a database cannot be read or written
MergeSummary merge_store(const ShapeStore& source, ShapeStore& target);

}  // namespace mdbd
