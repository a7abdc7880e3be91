#include "query/answer_query.h"

#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "features/core/errors.h"
#include "features/descriptor/chirality.h"
#include "query/collect_vectors.h"
#include "query/sketches.h"
#include "query/vector_cache.h"

namespace mdbd {
namespace {

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

std::vector<float> stored_chirality(const ShapeStore& store, std::int64_t id) {
  return compute_chirality(store.data(id).balls);
}

std::unique_ptr<const SignatureMetric> make_base_metric(const Recipe& recipe,
                                                        const QueryOptions& options) {
  return options.signature == SignatureKind::mdbd_100
             ? similarity_metric(recipe.descriptor_balls,
                                 options.walk_weight.value_or(recipe.walk_weight))
             : fused_metric();
}

std::unique_ptr<const SignatureMetric> make_metric(const Recipe& recipe,
                                                   const QueryOptions& options) {
  std::unique_ptr<const SignatureMetric> metric = make_base_metric(recipe, options);
  return options.has_chirality ? chiral_metric(std::move(metric)) : std::move(metric);
}

VectorTable with_chirality(const ShapeStore& store, const VectorTable& table) {
  VectorTableBuilder all;
  for (const StoredVector vector : table) {
    std::vector<float> values = stored_chirality(store, vector.shape_id);
    values.insert(values.end(), vector.values.begin(), vector.values.end());
    all.append({vector.shape_id, vector.path, vector.scale, values});
  }
  return all.take();
}

/// Vectors with their sketches, if these were in a cache or went into one.
struct Vectors {
  VectorTable table;
  std::optional<Sketches> sketches;
};

/// Reads all vectors, and writes the cache if nobody changed the store meanwhile.
Vectors fill_cache(const ShapeStore& store, const QueryOptions& options,
                   const std::filesystem::path& cache, const std::string& key,
                   std::size_t& completed) {
  Vectors vectors{.table = collect_vectors(store, options.signature, {}, {}, completed),
                  .sketches = std::nullopt};
  if (completed > 0 || vectors.table.size() < options.least_cached_models ||
      vector_cache_key(store, options.signature) != key) {
    return vectors;
  }
  const std::vector<MetricBlock> blocks =
      make_base_metric(store.recipe(), options)->blocks(vectors.table.dimension());
  vectors.sketches = make_sketches(vectors.table, blocks);
  write_vector_cache(cache, key, vectors.table, *vectors.sketches);
  return vectors;
}

/// The vectors of all models from the cache, which is made if it is not there or not to be trusted.
/// Nothing if there can be none, or if that would mean to compute vectors of models that nobody
/// asked for.
std::optional<Vectors> load_cached(const ShapeStore& store, const QueryOptions& options,
                                   bool is_cache_trusted, std::size_t& completed) {
  // Scales in the cache are those of the files.
  if (options.cached_database.empty() || !options.unit.empty()) return std::nullopt;
  // Its sketches bound the distance of the recipe.
  if (options.walk_weight) return std::nullopt;
  const std::string key = vector_cache_key(store, options.signature);
  if (key.empty()) return std::nullopt;
  const std::filesystem::path cache = vector_cache_path(options.cached_database, options.signature);
  std::optional<CachedVectors> cached;
  if (is_cache_trusted) cached = read_vector_cache(cache, key);
  if (cached) {
    return Vectors{std::move(cached->table), std::move(cached->sketches)};
  }
  if (!options.filter.is_empty() && options.signature != SignatureKind::mdbd_100) {
    return std::nullopt;
  }
  return fill_cache(store, options, cache, key, completed);
}

ExactSearch make_search(const ShapeStore& store, const QueryOptions& options, std::size_t queries,
                        bool is_cache_trusted, std::size_t& completed) {
  std::optional<Vectors> cached = load_cached(store, options, is_cache_trusted, completed);
  VectorTable table =
      cached ? select_vectors(cached->table, options.filter)
             : collect_vectors(store, options.signature, options.filter, options.unit, completed);
  std::optional<Sketches> sketches;
  if (cached && options.filter.is_empty() && !options.has_chirality) {
    sketches = std::move(cached->sketches);
  }
  if (options.has_chirality) table = with_chirality(store, table);
  return ExactSearch(std::move(table), make_metric(store.recipe(), options), queries,
                     SearchMethod::automatic, std::move(sketches));
}

ShapeData to_data(ShapeDescription description) {
  return {.balls = std::move(description.decomposition.balls),
          .signature = std::move(description.descriptor.values),
          .fused = std::move(description.fused),
          .thumbnail = std::move(description.thumbnail)};
}

}  // namespace

/// What a shape is searched by.
struct ShapeSearch::Query {
  std::vector<float> vector;     ///< of the signature
  std::vector<float> chirality;  ///< empty unless it is asked for
  double scale = 0.0;            ///< R
  ShapeData data;                ///< empty unless it is asked for
};

/// What is searched.
struct ShapeSearch::Collection {
  std::size_t completed = 0;
  ExactSearch exact;
  std::optional<ApproximateSearch> approximate = std::nullopt;
  std::optional<Recall> recall = std::nullopt;
};

ShapeSearch::ShapeSearch(const ShapeStore& store, QueryOptions options, std::size_t queries)
    : store_(store), options_(std::move(options)), queries_(queries) {
  try {
    collection_ = load(true);
  } catch (const DamagedFile&) {
    collection_ = load(false);
  }
}

ShapeSearch::~ShapeSearch() = default;

std::unique_ptr<const ShapeSearch::Collection> ShapeSearch::load(bool is_cache_trusted) const {
  std::size_t completed = 0;
  ExactSearch exact = make_search(store_, options_, queries_, is_cache_trusted, completed);
  auto collection =
      std::make_unique<Collection>(Collection{.completed = completed, .exact = std::move(exact)});
  if (!options_.is_approximate || collection->exact.collection().empty()) return collection;
  collection->approximate.emplace(collection->exact);
  collection->recall = collection->approximate->measure_recall(collection->exact, options_.count);
  return collection;
}

void ShapeSearch::search(const Query& query, QueryAnswer& answer) const {
  SearchOptions search{.count = options_.count,
                       .threshold = options_.threshold,
                       .differences = options_.differences};
  if (options_.has_same_size) {
    search.min_scale = query.scale / same_size_ratio;
    search.max_scale = query.scale * same_size_ratio;
  }
  std::vector<float> vector = query.chirality;
  vector.insert(vector.end(), query.vector.begin(), query.vector.end());
  const auto& [completed, exact, approximate, recall] = *collection_;
  answer.completed = completed;
  answer.recall = recall;
  answer.result =
      approximate ? approximate->search(exact, vector, search) : exact.search(vector, search);
  if (!options_.has_chirality) return;
  for (Match& match : answer.result.matches) {
    const std::span<const float> values = exact.collection().values(match.row);
    match.hand = compare_hands(query.chirality, values.first(chirality_size));
  }
}

QueryAnswer ShapeSearch::answer(std::string name, Query query) {
  QueryAnswer answer{.query = std::move(name),
                     .result = {},
                     .radius_count = static_cast<std::size_t>(store_.recipe().descriptor_balls),
                     .query_scale = query.scale};
  try {
    search(query, answer);
  } catch (const DamagedFile&) {
    collection_ = load(false);
    search(query, answer);
  }
  answer.query_data = std::move(query.data);
  if (!options_.has_data) return answer;
  for (const Match& match : answer.result.matches) {
    answer.match_data.push_back(store_.data(match.id));
  }
  return answer;
}

QueryAnswer ShapeSearch::by_file(const std::filesystem::path& file, const DescribeQuery& describe) {
  ShapeDescription description = describe_query(file, store_.recipe(), describe);
  Query query{
      .vector = options_.signature == SignatureKind::mdbd_100 ? description.descriptor.values
                                                              : description.fused,
      .chirality = {},
      .scale =
          scale_in_unit(description.decomposition.scale, description.statistics, options_.unit),
      .data = {}};
  if (options_.has_chirality) query.chirality = compute_chirality(description.decomposition.balls);
  if (options_.has_data) query.data = to_data(std::move(description));
  return answer(file.string(), std::move(query));
}

QueryAnswer ShapeSearch::by_id(std::int64_t id) {
  const std::optional<ShapeRecord> record = store_.find(id);
  if (!record) {
    throw InvalidInput(fmt::format("no model of the database has id {}; --json shows the ids", id));
  }
  if (record->status == ShapeStatus::failed) {
    throw InvalidInput(
        fmt::format("model {} ({}) could not be indexed: {}", id, record->path, record->reason));
  }
  Query query{.vector = stored_vector(store_, id, options_.signature),
              .chirality = {},
              .scale = scale_in_unit(record->scale, record->statistics, options_.unit),
              .data = {}};
  if (options_.has_chirality) query.chirality = stored_chirality(store_, id);
  if (options_.has_data) query.data = store_.data(id);
  return answer(record->path, std::move(query));
}

QueryAnswer query_by_file(const ShapeStore& store, const std::filesystem::path& file,
                          const QueryOptions& options, const DescribeQuery& describe) {
  return ShapeSearch(store, options).by_file(file, describe);
}

QueryAnswer query_by_id(const ShapeStore& store, std::int64_t id, const QueryOptions& options) {
  return ShapeSearch(store, options).by_id(id);
}

}  // namespace mdbd
