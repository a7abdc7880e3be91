#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "features/descriptor/similarity_distance.h"
#include "query/nearest_neighbours.h"
#include "store/shape_record.h"

namespace mdbd {

/// A model of the collection with its similarity distance to the query.
struct Match {
  std::int64_t id = 0;
  std::string path;
  double scale = 0.0;  ///< R in object units
  SimilarityDistance distance;
};

/// The answer of a search.
struct SearchResult {
  std::vector<Match> matches;  ///< ordered by total distance and, at equal distance, by path
  bool exact = false;          ///< no other model can be nearer: certified, or all were examined
  std::size_t collection_size = 0;
  std::size_t examined = 0;  ///< models whose similarity distance was computed
};

/// Exact top-k under the similarity distance d = |f_R - g_R| + alpha |f_P - g_P| (paper, section
/// 5.2), which is a metric but no Euclidean one. The Euclidean distance L2 of the concatenations
/// (f_R, alpha f_P) bounds it from below, so L2 neighbours are examined in increasing order until
/// the next L2 exceeds the k-th smallest d found: the exactness certificate.
class ExactSearch {
 public:
  /// @param collection vectors laid out as Descriptor::values, all of one dimension; may be empty
  /// @param radius_count k of the recipe, how many of the values are radii
  /// @param walk_weight alpha, at least 0
  /// @throws InvalidInput if a vector has another dimension than the first, fewer than radius_count
  ///         values, or a value that NearestNeighbours refuses
  ExactSearch(std::vector<StoredVector> collection, int radius_count, double walk_weight);

  /// The k nearest models, or all if there are fewer.
  /// @throws InvalidInput if k is 0 or the query has another dimension than the collection
  SearchResult search(std::span<const float> query, std::size_t k) const;

 private:
  struct Candidate;
  Candidate examine(std::span<const float> query, std::size_t row) const;
  std::vector<Match> best_matches(std::vector<Candidate> candidates, std::size_t count) const;
  std::vector<float> weighted(std::span<const float> values) const;
  NearestNeighbours index_collection() const;
  double lower_bound(double euclidean_distance, double query_norm) const;

  std::vector<StoredVector> collection_;
  int radius_count_;
  double walk_weight_;
  NearestNeighbours neighbours_;  // over the weighted vectors
  double largest_norm_ = 0.0;     // of the weighted vectors
};

}  // namespace mdbd
