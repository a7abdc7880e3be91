#include "query/exact_search.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "features/core/errors.h"

namespace mdbd {
namespace {

// Sketches of more numbers rule out more vectors and take longer to compare: measured by
// bench/search_benchmark.cpp.
constexpr std::size_t euclidean_sketch_size = 8;
constexpr std::size_t l1_sketch_size = 64;

// Building an index takes as long as some fifty scans.
constexpr std::size_t least_indexed_size = 10'000;
constexpr std::size_t least_indexed_searches = 100;

// Whether all numbers stay far from overflow when they are multiplied by a weight; false for NaN.
bool are_usable(std::span<const float> values, double weight) {
  return std::ranges::all_of(values, [weight](float value) {
    return weight * std::abs(value) <= MetricSketch::largest_component;
  });
}

/// The sum of the magnitudes of the numbers of a vector.
/// @throws InvalidInput if one is not finite or far too large, weighted or not
double magnitude(std::span<const float> values, std::span<const MetricBlock> blocks) {
  bool is_usable = are_usable(values, 1.0);
  for (const MetricBlock& block : blocks) {
    is_usable = is_usable && are_usable(values.subspan(block.first, block.count), block.weight);
  }
  if (!is_usable) throw InvalidInput("a vector holds a value that is not finite or far too large");
  double sum = 0.0;
  for (const float value : values) sum += std::abs(value);
  return sum;
}

/// What each number of two vectors adds to their distance, before the norm is taken.
std::vector<double> weighted_differences(std::span<const MetricBlock> blocks,
                                         std::span<const float> f, std::span<const float> g) {
  std::vector<double> result(f.size(), 0.0);
  for (const MetricBlock& block : blocks) {
    for (std::size_t i = block.first; i < block.first + block.count; ++i) {
      result[i] = block.weight * std::abs(double{f[i]} - double{g[i]});
    }
  }
  return result;
}

std::vector<NumberDifference> largest_differences(const SignatureMetric& metric,
                                                  std::span<const MetricBlock> blocks,
                                                  std::span<const float> query,
                                                  std::span<const float> match, std::size_t count) {
  if (count == 0) return {};
  const std::vector<double> added = weighted_differences(blocks, query, match);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (added[i] > 0.0) order.push_back(i);
  }
  count = std::min(count, order.size());
  std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(count), {},
                            [&](std::size_t i) { return std::pair(-added[i], i); });
  std::vector<NumberDifference> result;
  for (const std::size_t i : std::span(order).first(count)) {
    result.push_back({metric.number_name(i), query[i], match[i]});
  }
  return result;
}

}  // namespace

struct ExactSearch::Candidate {
  std::size_t row;
  double distance;
};

/// The best models so far, and the distance beyond which none is of interest any more.
class ExactSearch::Candidates {
 public:
  Candidates(const ExactSearch& search, std::span<const float> query, const SearchOptions& options)
      : search_(search), query_(query), options_(options), limit_(options.threshold) {}

  double limit() const { return limit_; }
  std::size_t examined() const { return examined_; }

  /// Compares a model with the query, unless a bound rules it out.
  void consider(std::size_t row) {
    const StoredVector& vector = search_.collection_[row];
    if (vector.scale < options_.min_scale || vector.scale > options_.max_scale) return;
    const double bound = block_distance(query_, vector.values, search_.blocks_);
    if (bound * (1.0 - search_.margin_) > limit_) return;
    ++examined_;
    const Candidate candidate{row, search_.metric_->distance(query_, vector.values)};
    if (candidate.distance <= limit_) add(candidate);
  }

  /// The best, in order.
  std::vector<Candidate> take() {
    std::ranges::sort(best_, [this](const auto& a, const auto& b) { return is_better(a, b); });
    return std::move(best_);
  }

 private:
  bool is_better(const Candidate& a, const Candidate& b) const {
    if (a.distance != b.distance) return a.distance < b.distance;
    return search_.collection_[a.row].path < search_.collection_[b.row].path;
  }

  void add(const Candidate& candidate) {
    const auto order = [this](const auto& a, const auto& b) { return is_better(a, b); };
    best_.push_back(candidate);
    std::ranges::push_heap(best_, order);
    if (best_.size() > options_.count) {
      std::ranges::pop_heap(best_, order);
      best_.pop_back();
    }
    if (best_.size() == options_.count) limit_ = best_.front().distance;
  }

  const ExactSearch& search_;
  std::span<const float> query_;
  const SearchOptions& options_;
  std::vector<Candidate> best_;  // a heap with the worst in front
  double limit_;
  std::size_t examined_ = 0;
};

ExactSearch::ExactSearch(std::vector<StoredVector> collection,
                         std::unique_ptr<const SignatureMetric> metric, std::size_t searches,
                         SearchMethod method)
    : collection_(std::move(collection)), metric_(std::move(metric)) {
  if (collection_.empty()) return;
  dimension_ = collection_.front().values.size();
  for (const StoredVector& vector : collection_) {
    if (vector.values.size() != dimension_ || dimension_ < metric_->least_size()) {
      throw InvalidInput(vector.path + ": its vector has " + std::to_string(vector.values.size()) +
                         " numbers, which does not fit the collection");
    }
    scales_.push_back(vector.scale);
  }
  std::ranges::sort(scales_);
  blocks_ = metric_->blocks(dimension_);
  margin_ = single_precision_margin(dimension_);
  for (const StoredVector& vector : collection_) {
    largest_magnitude_ = std::max(largest_magnitude_, magnitude(vector.values, blocks_));
  }
  const bool pays = collection_.size() >= least_indexed_size && searches >= least_indexed_searches;
  if (method == SearchMethod::index || (method == SearchMethod::automatic && pays)) {
    index_ = build_index();
  }
}

std::optional<ExactSearch::Index> ExactSearch::build_index() const {
  const std::size_t size =
      blocks_.front().norm == PointNorm::l1 ? l1_sketch_size : euclidean_sketch_size;
  MetricSketch sketch(collection_, blocks_, size);
  std::vector<float> points(collection_.size() * sketch.size());
  for (std::size_t row = 0; row < collection_.size(); ++row) {
    sketch.write(collection_[row].values,
                 std::span(points).subspan(row * sketch.size(), sketch.size()));
  }
  if (sketch.norm() == PointNorm::l1) {
    SketchList list(points, sketch.size());
    return Index{std::move(sketch), std::move(list)};
  }
  SketchTree tree(std::move(points), sketch.size());
  return Index{std::move(sketch), std::move(tree)};
}

std::size_t ExactSearch::count_within(const SearchOptions& options) const {
  const auto first = std::ranges::lower_bound(scales_, options.min_scale);
  const auto end = std::upper_bound(first, scales_.end(), options.max_scale);
  return static_cast<std::size_t>(end - first);
}

void ExactSearch::scan(Candidates& candidates) const {
  for (std::size_t row = 0; row < collection_.size(); ++row) candidates.consider(row);
}

void ExactSearch::visit_index(std::span<const float> query, Candidates& candidates) const {
  const double margin =
      index_->sketch.margin(std::max(largest_magnitude_, magnitude(query, blocks_)));
  std::vector<float> sketch(index_->sketch.size());
  index_->sketch.write(query, sketch);
  const auto visitor = [&](std::size_t row) {
    candidates.consider(row);
    return candidates.limit() + margin;
  };
  std::visit(
      [&](const auto& points) {
        points.visit_within(sketch, candidates.limit() + margin, visitor);
      },
      index_->points);
}

SearchResult ExactSearch::search(std::span<const float> query, const SearchOptions& options) const {
  if (options.count == 0) throw InvalidInput("the number of matches asked for must be at least 1");
  SearchResult result;
  result.part_names = metric_->part_names();
  if (collection_.empty()) return result;
  if (query.size() != dimension_) {
    throw InvalidInput("a query of " + std::to_string(query.size()) +
                       " numbers against vectors of " + std::to_string(dimension_));
  }
  magnitude(query, blocks_);
  Candidates candidates(*this, query, options);
  if (index_) {
    visit_index(query, candidates);
  } else {
    scan(candidates);
  }
  result.compared = count_within(options);
  result.examined = candidates.examined();
  for (const Candidate& candidate : candidates.take()) {
    result.matches.push_back(describe(query, candidate, options.differences));
  }
  return result;
}

Match ExactSearch::describe(std::span<const float> query, const Candidate& candidate,
                            std::size_t differences) const {
  const StoredVector& model = collection_[candidate.row];
  return {.row = candidate.row,
          .id = model.shape_id,
          .path = model.path,
          .scale = model.scale,
          .distance = candidate.distance,
          .parts = metric_->parts(query, model.values),
          .differences = largest_differences(*metric_, blocks_, query, model.values, differences),
          .hand = std::nullopt};
}

}  // namespace mdbd
