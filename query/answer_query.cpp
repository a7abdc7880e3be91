#include "query/answer_query.h"

#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "features/core/errors.h"
#include "features/descriptor/chirality.h"
#include "features/descriptor/fused_signature.h"

namespace mdbd {
namespace {

/// What a shape is searched by.
struct Query {
  std::vector<float> vector;     ///< of the signature
  std::vector<float> chirality;  ///< empty unless it is asked for
};

ShapeDescription describe_query(const std::filesystem::path& file, const Recipe& recipe,
                                const DescribeQuery& describe) {
  try {
    return describe(file, recipe);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const IoError& error) {
    throw IoError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::vector<float> stored_vector(const ShapeStore& store, std::int64_t id,
                                 SignatureKind signature) {
  ShapeData data = store.data(id);
  if (signature == SignatureKind::mdbd_100) return std::move(data.signature);
  return data.fused.empty() ? compute_fused_signature(data.balls) : std::move(data.fused);
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
    vectors.push_back(
        {id, record->path, record->scale, stored_vector(store, id, SignatureKind::mdbd_fused)});
    ++completed;
  }
  return vectors;
}

std::vector<float> stored_chirality(const ShapeStore& store, std::int64_t id) {
  return compute_chirality(store.data(id).balls);
}

/// The vectors of a collection, with the chirality in front if it is asked for.
std::vector<StoredVector> collect(const ShapeStore& store, const QueryOptions& options,
                                  std::size_t& completed) {
  std::vector<StoredVector> vectors = options.signature == SignatureKind::mdbd_100
                                          ? store.vectors(signature_mdbd_100)
                                          : fused_vectors(store, completed);
  if (!options.has_chirality) return vectors;
  for (StoredVector& vector : vectors) {
    const std::vector<float> chirality = stored_chirality(store, vector.shape_id);
    vector.values.insert(vector.values.begin(), chirality.begin(), chirality.end());
  }
  return vectors;
}

std::unique_ptr<const SignatureMetric> make_metric(const Recipe& recipe,
                                                   const QueryOptions& options) {
  std::unique_ptr<const SignatureMetric> metric =
      options.signature == SignatureKind::mdbd_100
          ? similarity_metric(recipe.descriptor_balls, recipe.walk_weight)
          : fused_metric();
  return options.has_chirality ? chiral_metric(std::move(metric)) : std::move(metric);
}

QueryAnswer search(const ShapeStore& store, std::string name, Query query,
                   const QueryOptions& options) {
  QueryAnswer answer{.query = std::move(name), .result = {}};
  const ExactSearch collection(collect(store, options, answer.completed),
                               make_metric(store.recipe(), options));
  query.vector.insert(query.vector.begin(), query.chirality.begin(), query.chirality.end());
  answer.result = collection.search(query.vector, options.count, options.differences);
  if (!options.has_chirality) return answer;
  for (Match& match : answer.result.matches) {
    match.hand = compare_hands(query.chirality, stored_chirality(store, match.id));
  }
  return answer;
}

}  // namespace

QueryAnswer query_by_file(const ShapeStore& store, const std::filesystem::path& file,
                          const QueryOptions& options, const DescribeQuery& describe) {
  ShapeDescription description = describe_query(file, store.recipe(), describe);
  Query query{.vector = options.signature == SignatureKind::mdbd_100
                            ? std::move(description.descriptor.values)
                            : std::move(description.fused),
              .chirality = {}};
  if (options.has_chirality) query.chirality = compute_chirality(description.decomposition.balls);
  return search(store, file.string(), std::move(query), options);
}

QueryAnswer query_by_id(const ShapeStore& store, std::int64_t id, const QueryOptions& options) {
  const std::optional<ShapeRecord> record = store.find(id);
  if (!record) {
    throw InvalidInput(fmt::format("no model of the database has id {}; --json shows the ids", id));
  }
  if (record->status == ShapeStatus::failed) {
    throw InvalidInput(
        fmt::format("model {} ({}) could not be indexed: {}", id, record->path, record->reason));
  }
  Query query{.vector = stored_vector(store, id, options.signature), .chirality = {}};
  if (options.has_chirality) query.chirality = stored_chirality(store, id);
  return search(store, record->path, std::move(query), options);
}

}  // namespace mdbd
