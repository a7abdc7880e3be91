#include "db/merge_stores.h"

#include <optional>

#include "features/core/errors.h"

namespace mdbd {
namespace {

bool is_better(const ShapeRecord& left, const ShapeRecord& right) {
  if (left.status != right.status) return left.status == ShapeStatus::indexed;
  return left.modified_ns > right.modified_ns;
}

}  // namespace

MergeSummary merge_store(const ShapeStore& source, ShapeStore& target) {
  const std::string difference = describe_difference(target.recipe(), source.recipe());
  if (!difference.empty()) {
    throw StoreError("databases of different recipes cannot be merged: " + difference);
  }
  MergeSummary summary;
  for (const ShapeRecord& record : source.shapes()) {
    const std::optional<ShapeRecord> existing = target.find_by_path(record.path);
    if (existing && !is_better(record, *existing)) {
      ++summary.kept;
      continue;
    }
    target.put(record, source.data(record.id));
    ++(existing ? summary.replaced : summary.added);
  }
  return summary;
}

}  // namespace mdbd
