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

// Another process may add vectors meanwhile: what is missing is asked for first, so that no model
// is left out, and what is there by then is not taken twice.
std::vector<StoredVector> fused_vectors(const ShapeStore& store, const CollectionFilter& filter,
                                        const std::string& unit, std::size_t& completed) {
  const std::vector<std::int64_t> missing = store.shapes_without(stored_mdbd_fused);
  std::vector<StoredVector> vectors = store.vectors(stored_mdbd_fused);
  std::unordered_set<std::int64_t> known;
  for (const StoredVector& vector : vectors) known.insert(vector.shape_id);
  for (const std::int64_t id : missing) {
    const std::optional<ShapeRecord> record = store.find(id);
    if (!record || record->status == ShapeStatus::failed || known.contains(id) ||
        !filter.accepts(record->path, scale_in_unit(record->scale, record->statistics, unit))) {
      continue;
    }
    vectors.push_back(
        {id, record->path, record->scale, stored_vector(store, id, SignatureKind::mdbd_fused)});
    ++completed;
  }
  return vectors;
}

void convert_scales(const ShapeStore& store, const std::string& unit,
                    std::vector<StoredVector>& vectors) {
  std::unordered_map<std::int64_t, double> scales;
  for (const ShapeRecord& record : store.shapes()) {
    scales[record.id] = scale_in_unit(record.scale, record.statistics, unit);
  }
  for (StoredVector& vector : vectors) {
    const auto known = scales.find(vector.shape_id);
    if (known != scales.end()) vector.scale = known->second;
  }
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

std::vector<StoredVector> collect_vectors(const ShapeStore& store, SignatureKind signature,
                                          const CollectionFilter& filter, const std::string& unit,
                                          std::size_t& completed) {
  std::vector<StoredVector> vectors = signature == SignatureKind::mdbd_100
                                          ? store.vectors(signature_mdbd_100)
                                          : fused_vectors(store, filter, unit, completed);
  if (!unit.empty()) convert_scales(store, unit, vectors);
  if (!filter.is_empty()) {
    std::erase_if(vectors, [&](const StoredVector& vector) {
      return !filter.accepts(vector.path, vector.scale);
    });
  }
  return vectors;
}

}  // namespace mdbd
