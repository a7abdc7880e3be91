#include "query/answer_query.h"

#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "features/core/errors.h"
#include "features/describe.h"
#include "features/descriptor/fused_signature.h"

namespace mdbd {
namespace {

std::vector<float> describe_query(const std::filesystem::path& file, const Recipe& recipe,
                                  SignatureKind signature) {
  try {
    ShapeDescription description = describe_file(file, recipe);
    return signature == SignatureKind::mdbd_100 ? std::move(description.descriptor.values)
                                                : std::move(description.fused);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const IoError& error) {
    throw IoError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::vector<float> stored_vector(const ShapeStore& store, const ShapeRecord& record,
                                 SignatureKind signature) {
  ShapeData data = store.data(record.id);
  if (signature == SignatureKind::mdbd_100) return std::move(data.signature);
  return data.fused.empty() ? compute_fused_signature(data.balls)
                            : std::move(data.fused);
}

// Another process may add vectors meanwhile: what is missing is asked for first, so that no model
// is left out, and what is there by then is not taken twice.
std::vector<StoredVector> fused_vectors(const ShapeStore& store, std::size_t& completed) {
  const std::vector<std::int64_t> missing = store.shapes_without(stored_mdbd_fused);
  std::vector<StoredVector> vectors = store.vectors(stored_mdbd_fused);
  std::unordered_set<std::int64_t> known;
  for (const StoredVector& vector : vectors) known.insert(vector.shape_id);
  for (const std::int64_t id : missing) {
    const std::optional<ShapeRecord> record = store.find(id);
    if (!record || record->status == ShapeStatus::failed || known.contains(id)) continue;
    vectors.push_back({id, record->path, record->scale,
                       stored_vector(store, *record, SignatureKind::mdbd_fused)});
    ++completed;
  }
  return vectors;
}

QueryAnswer search(const ShapeStore& store, std::string name, std::span<const float> query,
                   std::size_t count, SignatureKind signature) {
  QueryAnswer answer{.query = std::move(name), .result = {}};
  const Recipe& recipe = store.recipe();
  const ExactSearch collection =
      signature == SignatureKind::mdbd_100
          ? ExactSearch(store.vectors(signature_mdbd_100),
                        similarity_metric(recipe.descriptor_balls, recipe.walk_weight))
          : ExactSearch(fused_vectors(store, answer.completed), fused_metric());
  answer.result = collection.search(query, count);
  return answer;
}

}  // namespace

QueryAnswer query_by_file(const ShapeStore& store, const std::filesystem::path& file,
                          std::size_t count, SignatureKind signature) {
  const std::vector<float> query = describe_query(file, store.recipe(), signature);
  return search(store, file.string(), query, count, signature);
}

QueryAnswer query_by_id(const ShapeStore& store, std::int64_t id, std::size_t count,
                        SignatureKind signature) {
  const std::optional<ShapeRecord> record = store.find(id);
  if (!record) {
    throw InvalidInput(fmt::format("no model of the database has id {}; --json shows the ids", id));
  }
  if (record->status == ShapeStatus::failed) {
    throw InvalidInput(
        fmt::format("model {} ({}) could not be indexed: {}", id, record->path, record->reason));
  }
  return search(store, record->path, stored_vector(store, *record, signature), count, signature);
}

}  // namespace mdbd
