#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "store/shape_store.h"

namespace mdbd {

/// What was found wrong with the content of a database.
struct Verification {
  std::size_t models = 0;             ///< indexed ones that were looked at
  std::vector<std::string> problems;  ///< a line each
};

/// Computes both signatures of every indexed model anew from its balls and compares them with the
/// stored ones, to 1e-5: another machine may round a last digit in another way.
/// @throws StoreError if the collection cannot be read at all
Verification verify_store(const ShapeStore& store);

}  // namespace mdbd
