#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "query/cluster_tree.h"
#include "query/exact_search.h"

namespace mdbd {

/// How many of the nearest models an approximate search finds.
struct Recall {
  double share = 1.0;       ///< of the models of the exact answers
  std::size_t count = 0;    ///< how many models are asked for
  std::size_t sampled = 0;  ///< how many models of the collection were searched with
};

/// Finds most of the nearest models: candidates from FLANN's hierarchical k-means tree by the norm
/// of the metric's blocks, taken together, ordered by their true distance. The same collection
/// gives the same answers.
class ApproximateSearch {
 public:
  /// Builds the tree, which takes long.
  /// @pre the collection of the search is not empty
  explicit ApproximateSearch(const ExactSearch& exact);

  /// As ExactSearch::search(), but with models missing.
  /// @param exact the search of the constructor
  SearchResult search(const ExactSearch& exact, std::span<const float> query,
                      const SearchOptions& options) const;

  /// Compares approximate with exact answers, for at most 100 models of the collection, evenly
  /// spaced in it.
  Recall measure_recall(const ExactSearch& exact, std::size_t count) const;

 private:
  std::vector<MetricBlock> blocks_;
  ClusterTree tree_;
};

}  // namespace mdbd
