#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "features/descriptor/chirality.h"
#include "query/signature_metric.h"
#include "query/sketch_tree.h"
#include "query/sketches.h"
#include "store/vector_table.h"

namespace mdbd {

/// A number in which a model differs from the query.
struct NumberDifference {
  std::string name;  ///< what it says
  float query = 0.0F;
  float match = 0.0F;
};

/// A model of the collection with its distance to the query.
struct Match {
  std::size_t row = 0;  ///< of ExactSearch::collection()
  std::int64_t id = 0;
  std::string path;
  double scale = 0.0;  ///< R in object units
  double distance = 0.0;
  std::vector<double> parts;  ///< of the distance: SearchResult::part_names
  /// The numbers that differ the most by what they add to the distance, the largest difference
  /// first; none where the vectors are equal.
  std::vector<NumberDifference> differences;
  std::optional<Hand> hand;  ///< if it was asked for
};

/// The answer of a search: no model that is not among the matches is nearer.
struct SearchResult {
  std::vector<Match> matches;  ///< ordered by distance and, at equal distance, by path
  std::vector<std::string_view> part_names;
  std::size_t compared = 0;  ///< models within the range of R, those that a bound ruled out, too
  std::size_t examined = 0;  ///< models whose distance was computed
};

/// What is asked of a collection.
struct SearchOptions {
  std::size_t count = 10;  ///< how many models, at least 1
  /// The largest distance.
  double threshold = std::numeric_limits<double>::infinity();
  /// The range of R in object units: models outside are as if they were not there.
  double min_scale = 0.0;
  double max_scale = std::numeric_limits<double>::infinity();
  /// How many of the numbers that differ the most are told of each match.
  std::size_t differences = 0;
};

/// How a collection is searched; the answers are the same.
enum class SearchMethod {
  automatic,  ///< whatever takes less time for the searches to come
  scan,       ///< every vector is compared, in single precision first: nothing to build
  list,       ///< sketches (metric_sketch.h) say which vectors to compare; all of them are compared
  tree        ///< sketches are in FLANN's kd-tree, for Euclidean blocks; for L1 as `list`
};

/// Exact top-k under the metric of a signature. Every bound used is below the distance whatever
/// rounding does, and what it does not rule out is compared in double precision: that is the
/// exactness certificate. Of a collection that lies in a file only what is compared is read; all
/// functions throw DamagedFile if that is not what was written.
class ExactSearch {
 public:
  /// @param collection vectors of the signature; may be empty
  /// @param searches how many are to come, for SearchMethod::automatic
  /// @param sketches of the collection by the blocks of the metric, if they are there already
  /// @throws InvalidInput if the vectors have fewer values than the metric needs, or a value that
  ///         is not finite or, weighted or not, above MetricSketch::largest_component
  ExactSearch(VectorTable collection, std::unique_ptr<const SignatureMetric> metric,
              std::size_t searches = 1, SearchMethod method = SearchMethod::automatic,
              std::optional<Sketches> sketches = std::nullopt);

  /// The nearest models within the threshold, as many as asked for or all if there are fewer.
  /// @throws InvalidInput if the count is 0, or the query has another dimension than the collection
  ///         or a value that the constructor refuses
  SearchResult search(std::span<const float> query, const SearchOptions& options = {}) const;

  /// As search(), among some rows of the collection only.
  SearchResult search_among(std::span<const std::size_t> rows, std::span<const float> query,
                            const SearchOptions& options) const;

  const VectorTable& collection() const { return collection_; }
  std::span<const MetricBlock> blocks() const { return blocks_; }
  bool has_index() const { return sketches_.has_value(); }

 private:
  struct Candidate;
  class Candidates;
  void check_values() const;
  void build_index(std::size_t searches, SearchMethod method);
  std::size_t count_within(const SearchOptions& options) const;
  void check_query(std::span<const float> query, const SearchOptions& options) const;
  SearchResult finish(std::span<const float> query, const SearchOptions& options,
                      Candidates& candidates) const;
  void scan(Candidates& candidates) const;
  void visit_index(std::span<const float> query, Candidates& candidates) const;
  Match describe(std::span<const float> query, const Candidate& candidate,
                 std::size_t differences) const;

  VectorTable collection_;
  std::unique_ptr<const SignatureMetric> metric_;
  std::vector<MetricBlock> blocks_;
  double margin_ = 0.0;  ///< single_precision_margin() of the vectors
  std::optional<Sketches> sketches_;
  std::optional<SketchTree> tree_;  ///< of the sketches
};

}  // namespace mdbd
