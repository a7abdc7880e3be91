#include "query/collect_vectors.h"

#include <optional>
#include <unordered_set>
#include <utility>

#include "features/descriptor/fused_signature.h"

namespace mdbd {
namespace {

// Another process may add vectors meanwhile: what is missing is asked for first, so that no model
// is left out, and what is there by then is not taken twice.
VectorTable fused_vectors(const ShapeStore& store, const CollectionFilter& filter,
                          std::size_t& completed) {
  const std::vector<std::int64_t> missing = store.shapes_without(stored_mdbd_fused);
  VectorTable stored = select_vectors(store.vectors(stored_mdbd_fused), filter);
  if (missing.empty()) return stored;
  VectorTableBuilder all;
  std::unordered_set<std::int64_t> known;
  for (const StoredVector vector : stored) {
    known.insert(vector.shape_id);
    all.append(vector);
  }
  for (const std::int64_t id : missing) {
    const std::optional<ShapeRecord> record = store.find(id);
    if (!record || record->status == ShapeStatus::failed || known.contains(id) ||
        !filter.accepts(record->path, record->scale)) {
      continue;
    }
    const std::vector<float> values = stored_vector(store, id, SignatureKind::mdbd_fused);
    all.append({id, record->path, record->scale, values});
    ++completed;
  }
  return all.take();
}

}  // namespace

std::vector<float> stored_vector(const ShapeStore& store, std::int64_t id,
                                 SignatureKind signature) {
  ShapeData data = store.data(id);
  if (signature == SignatureKind::mdbd_100) return std::move(data.signature);
  return data.fused.empty() ? compute_fused_signature(data.balls) : std::move(data.fused);
}

VectorTable collect_vectors(const ShapeStore& store, SignatureKind signature,
                            const CollectionFilter& filter, std::size_t& completed) {
  return signature == SignatureKind::mdbd_100
             ? select_vectors(store.vectors(signature_mdbd_100), filter)
             : fused_vectors(store, filter, completed);
}

VectorTable select_vectors(const VectorTable& table, const CollectionFilter& filter) {
  if (filter.is_empty()) return table;
  VectorTableBuilder selected;
  for (const StoredVector vector : table) {
    if (filter.accepts(vector.path, vector.scale)) selected.append(vector);
  }
  return selected.take();
}

}  // namespace mdbd
