#include "query/approximate_search.h"

#include <algorithm>
#include <limits>
#include <unordered_set>

namespace mdbd {
namespace {

constexpr std::size_t largest_sample = 100;

// So many candidates for each model asked for, and so many comparisons for each candidate.
constexpr std::size_t candidate_factor = 4;
constexpr std::size_t least_candidates = 100;
constexpr std::size_t checks_factor = 10;

/// A vector by whose norm the tree compares: each block times its weight.
void append_weighted(std::span<const float> values, std::span<const MetricBlock> blocks,
                     std::vector<float>& points) {
  for (const MetricBlock& block : blocks) {
    for (const float value : values.subspan(block.first, block.count)) {
      points.push_back(static_cast<float>(block.weight) * value);
    }
  }
}

ClusterTree make_tree(const VectorTable& table, std::span<const MetricBlock> blocks) {
  std::vector<float> points;
  points.reserve(table.arrays().values.size());
  for (std::size_t row = 0; row < table.size(); ++row) {
    append_weighted(table.values(row), blocks, points);
  }
  const std::size_t dimension = points.size() / table.size();
  return ClusterTree(std::move(points), dimension, blocks.front().norm);
}

}  // namespace

ApproximateSearch::ApproximateSearch(const ExactSearch& exact)
    : blocks_(exact.blocks().begin(), exact.blocks().end()),
      tree_(make_tree(exact.collection(), blocks_)) {}

SearchResult ApproximateSearch::search(const ExactSearch& exact, std::span<const float> query,
                                       const SearchOptions& options) const {
  std::vector<float> point;
  append_weighted(query, blocks_, point);
  const std::size_t size = exact.collection().size();
  const std::size_t asked = std::min(options.count, size);
  const std::size_t candidates =
      std::min(std::max(candidate_factor * asked, least_candidates), size);
  const auto checks = static_cast<int>(
      std::min<std::size_t>(checks_factor * candidates, std::numeric_limits<int>::max()));
  return exact.search_among(tree_.find_near(point, candidates, checks), query, options);
}

Recall ApproximateSearch::measure_recall(const ExactSearch& exact, std::size_t count) const {
  const VectorTable& table = exact.collection();
  Recall recall{.count = count, .sampled = std::min(table.size(), largest_sample)};
  std::size_t found = 0;
  std::size_t expected = 0;
  for (std::size_t i = 0; i < recall.sampled; ++i) {
    const std::span<const float> query = table.values(i * table.size() / recall.sampled);
    const SearchResult truth = exact.search(query, {.count = count});
    std::unordered_set<std::size_t> rows;
    for (const Match& match : search(exact, query, {.count = count}).matches) {
      rows.insert(match.row);
    }
    for (const Match& match : truth.matches) found += rows.count(match.row);
    expected += truth.matches.size();
  }
  recall.share = expected > 0 ? static_cast<double>(found) / static_cast<double>(expected) : 1.0;
  return recall;
}

}  // namespace mdbd
