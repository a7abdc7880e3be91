#include "query/answer_query.h"

#include <span>
#include <utility>

#include <fmt/format.h>

#include "features/core/errors.h"
#include "features/descriptor/chirality.h"
#include "query/collect_vectors.h"

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

/// The vectors to search, with the chirality in front if it is asked for.
std::vector<StoredVector> collect(const ShapeStore& store, const QueryOptions& options,
                                  std::size_t& completed) {
  std::vector<StoredVector> vectors =
      collect_vectors(store, options.signature, options.filter, completed);
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

ShapeSearch::ShapeSearch(const ShapeStore& store, QueryOptions options, std::size_t queries)
    : store_(store),
      options_(std::move(options)),
      search_(collect(store, options_, completed_), make_metric(store.recipe(), options_),
              queries) {}

QueryAnswer ShapeSearch::answer(std::string name, Query query) const {
  QueryAnswer answer{.query = std::move(name),
                     .result = {},
                     .completed = completed_,
                     .radius_count = static_cast<std::size_t>(store_.recipe().descriptor_balls),
                     .query_scale = query.scale,
                     .query_data = std::move(query.data)};
  SearchOptions search{.count = options_.count,
                       .threshold = options_.threshold,
                       .differences = options_.differences};
  if (options_.has_same_size) {
    search.min_scale = query.scale / same_size_ratio;
    search.max_scale = query.scale * same_size_ratio;
  }
  query.vector.insert(query.vector.begin(), query.chirality.begin(), query.chirality.end());
  answer.result = search_.search(query.vector, search);
  if (options_.has_data) {
    for (const Match& match : answer.result.matches) {
      answer.match_data.push_back(store_.data(match.id));
    }
  }
  if (!options_.has_chirality) return answer;
  for (Match& match : answer.result.matches) {
    const std::span<const float> vector = search_.collection()[match.row].values;
    match.hand = compare_hands(query.chirality, vector.first(chirality_size));
  }
  return answer;
}

QueryAnswer ShapeSearch::by_file(const std::filesystem::path& file,
                                 const DescribeQuery& describe) const {
  ShapeDescription description = describe_query(file, store_.recipe(), describe);
  Query query{.vector = options_.signature == SignatureKind::mdbd_100
                            ? description.descriptor.values
                            : description.fused,
              .chirality = {},
              .scale = description.decomposition.scale,
              .data = {}};
  if (options_.has_chirality) query.chirality = compute_chirality(description.decomposition.balls);
  if (options_.has_data) query.data = to_data(std::move(description));
  return answer(file.string(), std::move(query));
}

QueryAnswer ShapeSearch::by_id(std::int64_t id) const {
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
              .scale = record->scale,
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
