#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "features/core/signature.h"
#include "features/describe.h"
#include "query/approximate_search.h"
#include "query/collection_filter.h"
#include "query/exact_search.h"
#include "query/vector_cache.h"
#include "store/shape_store.h"

namespace mdbd {

/// Two models are of the same size if the larger R is at most so many times the smaller one: 1 %
/// more, which is beyond what noise and decimation do to R, and below steps of sizes in catalogues.
inline constexpr double same_size_ratio = 1.01;

/// What is asked for.
struct QueryOptions {
  std::size_t count = 10;  ///< how many models, at least 1
  SignatureKind signature = SignatureKind::mdbd_100;
  bool has_chirality =
      false;  ///< mirrored shapes are told apart, at the price of reading all balls
  std::size_t differences = 0;  ///< how many of the numbers that differ the most are told
  double threshold = std::numeric_limits<double>::infinity();  ///< the largest distance
  /// The weight of the walk sums in the distance by mdbd-100 in place of the recipe's, at least 0.
  std::optional<double> walk_weight = std::nullopt;
  CollectionFilter filter = {};
  /// Sizes are in this unit (length_units): those of models whose unit is recorded are converted,
  /// others are taken to be in it. Empty: sizes are compared as they are.
  std::string unit = {};
  bool has_same_size = false;  ///< only models of the query's size: same_size_ratio
  /// Most of the nearest will do; not with has_same_size. The share is measured.
  bool is_approximate = false;
  /// The database of the store, beside which vectors are cached (vector_cache.h). Empty: nowhere.
  std::filesystem::path cached_database = {};
  std::size_t least_cached_models = mdbd::least_cached_models;
  bool has_data = false;  ///< the answer has what is stored of the query and of each match
};

/// A query by the path it is known by, with its answer.
struct QueryAnswer {
  std::string query;  ///< the path of the file or of the indexed model
  SearchResult result;
  /// Models whose vector was computed from their balls: the database is older than the signature.
  std::size_t completed = 0;
  std::size_t radius_count = 0;                 ///< k, how many numbers of mdbd-100 are radii
  double query_scale = 0.0;                     ///< R in object units
  ShapeData query_data = {};                    ///< if it was asked for
  std::vector<ShapeData> match_data = {};       ///< of each match, if it was asked for
  std::optional<Recall> recall = std::nullopt;  ///< if the answer is approximate
};

/// Describes a file by a recipe; throws as describe_file() does.
using DescribeQuery = std::function<ShapeDescription(const std::filesystem::path&, const Recipe&)>;

/// The vectors of a collection, read once for any number of queries; again, from the database, if
/// the cache turns out to be damaged.
class ShapeSearch {
 public:
  /// @param store must outlive this object
  /// @param queries how many are to come: many are worth an index
  /// @throws StoreError if the collection cannot be read
  ShapeSearch(const ShapeStore& store, QueryOptions options, std::size_t queries = 1);
  ~ShapeSearch();

  /// As query_by_file().
  QueryAnswer by_file(const std::filesystem::path& file,
                      const DescribeQuery& describe = describe_file);
  /// As query_by_id().
  QueryAnswer by_id(std::int64_t id);

 private:
  struct Query;
  struct Collection;
  std::unique_ptr<const Collection> load(bool is_cache_trusted) const;
  QueryAnswer answer(std::string name, Query query);
  void search(const Query& query, QueryAnswer& answer) const;

  const ShapeStore& store_;
  QueryOptions options_;
  std::size_t queries_;
  std::unique_ptr<const Collection> collection_;
};

/// The models of a collection that look most like a shape file. The file is described by the recipe
/// of the collection, so that an indexed file finds itself at distance 0.
/// @throws IoError or InvalidInput, with the path in front of the reason, if the file cannot be
/// used
/// @throws StoreError if the collection cannot be read
/// @param describe does it in a process of its own if the file is not to be trusted
QueryAnswer query_by_file(const ShapeStore& store, const std::filesystem::path& file,
                          const QueryOptions& options = {},
                          const DescribeQuery& describe = describe_file);

/// The models of a collection that look most like one of its own, which is among them. Needs no
/// file: vector and balls are the stored ones.
/// @throws InvalidInput if there is no such model or it failed when it was indexed
/// @throws StoreError if the collection cannot be read
QueryAnswer query_by_id(const ShapeStore& store, std::int64_t id, const QueryOptions& options = {});

}  // namespace mdbd
