#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "features/descriptor/chirality.h"
#include "query/nearest_neighbours.h"
#include "query/signature_metric.h"
#include "store/shape_record.h"

namespace mdbd {

/// A number in which a model differs from the query.
struct NumberDifference {
  std::string name;  ///< what it says
  float query = 0.0F;
  float match = 0.0F;
};

/// A model of the collection with its distance to the query.
struct Match {
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

/// The answer of a search.
struct SearchResult {
  std::vector<Match> matches;  ///< ordered by distance and, at equal distance, by path
  std::vector<std::string_view> part_names;
  bool exact = false;  ///< no other model can be nearer: certified, or all were examined
  std::size_t collection_size = 0;
  std::size_t examined = 0;  ///< models whose distance was computed
};

/// Exact top-k under the metric of a signature. The norm of the metric's points bounds its distance
/// d from below, so neighbours by that norm are examined in increasing order until the next norm
/// exceeds the k-th smallest d found: the exactness certificate.
class ExactSearch {
 public:
  /// @param collection vectors of the signature, all of one dimension; may be empty
  /// @throws InvalidInput if a vector has another dimension than the first, fewer values than the
  ///         metric needs, or a value that NearestNeighbours refuses
  ExactSearch(std::vector<StoredVector> collection, std::unique_ptr<const SignatureMetric> metric);

  /// The k nearest models, or all if there are fewer.
  /// @param differences how many of the numbers that differ the most are told of each
  /// @throws InvalidInput if k is 0 or the query has another dimension than the collection
  SearchResult search(std::span<const float> query, std::size_t k,
                      std::size_t differences = 0) const;

 private:
  struct Candidate;
  Candidate examine(std::span<const float> query, std::size_t row) const;
  std::vector<Match> best_matches(std::span<const float> query, std::vector<Candidate> candidates,
                                  std::size_t count, std::size_t differences) const;
  NearestNeighbours index_collection() const;
  double lower_bound(double point_distance, double query_norm) const;

  std::vector<StoredVector> collection_;
  std::unique_ptr<const SignatureMetric> metric_;
  NearestNeighbours neighbours_;  // over the points of the metric
  double largest_norm_ = 0.0;     // of the points
};

}  // namespace mdbd
