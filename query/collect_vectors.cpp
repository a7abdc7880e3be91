#include "query/collect_vectors.h"

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "features/core/length_unit.h"
#include "features/descriptor/fused_signature.h"
#include "features/shape_unit.h"

namespace mdbd {
namespace {

/// A signature's vectors with their scales in a unit.
VectorTable stored_table(const ShapeStore& store, std::string_view signature,
                         const std::string& unit) {
  VectorTable stored = store.vectors(signature);
  if (unit.empty()) return stored;
  std::unordered_map<std::int64_t, double> scales;
  for (const ShapeRecord& record : store.shapes()) {
    scales[record.id] = scale_in_unit(record.scale, record.statistics, unit);
  }
  VectorTableBuilder converted;
  for (StoredVector vector : stored) {
    const auto known = scales.find(vector.shape_id);
    if (known != scales.end()) vector.scale = known->second;
    converted.append(vector);
  }
  return converted.take();
}

// Another process may add vectors meanwhile: what is missing is asked for first, so that no model
// is left out, and what is there by then is not taken twice.
VectorTable fused_vectors(const ShapeStore& store, const CollectionFilter& filter,
                          const std::string& unit, std::size_t& completed) {
  const std::vector<std::int64_t> missing = store.shapes_without(stored_mdbd_fused);
  VectorTable stored = select_vectors(stored_table(store, stored_mdbd_fused, unit), filter);
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
        !filter.accepts(record->path, scale_in_unit(record->scale, record->statistics, unit))) {
      continue;
    }
    const std::vector<float> values = stored_vector(store, id, SignatureKind::mdbd_fused);
    all.append({id, record->path, scale_in_unit(record->scale, record->statistics, unit), values});
    ++completed;
  }
  return all.take();
}

}  // namespace

double scale_in_unit(double scale, const std::string& statistics, const std::string& unit) {
  if (unit.empty()) return scale;
  const std::optional<double> recorded = recorded_millimetres(statistics);
  return recorded ? scale * *recorded / millimetres_of(unit).value() : scale;
}

std::vector<float> stored_vector(const ShapeStore& store, std::int64_t id,
                                 SignatureKind signature) {
  ShapeData data = store.data(id);
  if (signature == SignatureKind::mdbd_100) return std::move(data.signature);
  return data.fused.empty() ? compute_fused_signature(data.balls) : std::move(data.fused);
}

VectorTable collect_vectors(const ShapeStore& store, SignatureKind signature,
                            const CollectionFilter& filter, const std::string& unit,
                            std::size_t& completed) {
  return signature == SignatureKind::mdbd_100
             ? select_vectors(stored_table(store, signature_mdbd_100, unit), filter)
             : fused_vectors(store, filter, unit, completed);
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
