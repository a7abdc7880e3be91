#include "query/exact_search.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "features/core/errors.h"

namespace mdbd {
namespace {

// Making sketches takes as long as some thirty scans, the tree as some three hundred passes over
// the list: measured by bench/search_benchmark.cpp.
constexpr std::size_t least_indexed_size = 10'000;
constexpr std::size_t least_sketched_searches = 50;
constexpr std::size_t least_tree_searches = 500;

constexpr std::size_t many_matches = 500;

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

bool is_within(double scale, const SearchOptions& options) {
  return scale >= options.min_scale && scale <= options.max_scale;
}

bool has_scale_range(const SearchOptions& options) {
  return options.min_scale > 0.0 || options.max_scale < std::numeric_limits<double>::infinity();
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
      : search_(search),
        query_(query),
        options_(options),
        has_scale_range_(has_scale_range(options)),
        limit_(options.threshold) {}

  double limit() const { return limit_; }
  std::size_t count() const { return options_.count; }
  std::size_t examined() const { return examined_; }

  /// Compares a model with the query, unless a bound rules it out.
  void consider(std::size_t row) {
    if (has_scale_range_ && !is_within(search_.collection_.scale(row), options_)) return;
    const std::span<const float> values = search_.collection_.values(row);
    const double bound = block_distance(query_, values, search_.blocks_);
    if (bound * (1.0 - search_.margin_) > limit_) return;
    ++examined_;
    const Candidate candidate{row, search_.metric_->distance(query_, values)};
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
    return search_.collection_.path(a.row) < search_.collection_.path(b.row);
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
  bool has_scale_range_;
  std::vector<Candidate> best_;  // a heap with the worst in front
  double limit_;
  std::size_t examined_ = 0;
};

ExactSearch::ExactSearch(VectorTable collection, std::unique_ptr<const SignatureMetric> metric,
                         std::size_t searches, SearchMethod method,
                         std::optional<Sketches> sketches)
    : collection_(std::move(collection)),
      metric_(std::move(metric)),
      sketches_(std::move(sketches)) {
  if (collection_.empty()) return;
  if (collection_.dimension() < metric_->least_size()) {
    throw InvalidInput(std::string(collection_.path(0)) + ": its vector has " +
                       std::to_string(collection_.dimension()) + " numbers, which are too few");
  }
  blocks_ = metric_->blocks(collection_.dimension());
  margin_ = single_precision_margin(collection_.dimension());
  check_values();
  build_index(searches, method);
}

void ExactSearch::check_values() const {
  double weight = 1.0;
  for (const MetricBlock& block : blocks_) weight = std::max(weight, block.weight);
  const float largest = collection_.largest_number();
  if (are_usable(std::span(&largest, 1), weight)) return;
  for (std::size_t row = 0; row < collection_.size(); ++row) {
    magnitude(collection_.values(row), blocks_);
  }
}

void ExactSearch::build_index(std::size_t searches, SearchMethod method) {
  if (method == SearchMethod::automatic) {
    const bool pays = collection_.size() >= least_indexed_size;
    method = pays && searches >= least_tree_searches                      ? SearchMethod::tree
             : sketches_ || (pays && searches >= least_sketched_searches) ? SearchMethod::list
                                                                          : SearchMethod::scan;
  }
  if (method == SearchMethod::scan) {
    sketches_.reset();
    return;
  }
  if (!sketches_) sketches_ = make_sketches(collection_, blocks_);
  if (method == SearchMethod::tree && sketches_->map.norm() == PointNorm::l2) {
    collection_.arrays();  // so many searches read nearly all of it, in no order
    tree_.emplace(sketches_->list.points(), sketches_->map.size());
  }
}

std::size_t ExactSearch::count_within(const SearchOptions& options) const {
  if (!has_scale_range(options)) return collection_.size();
  return static_cast<std::size_t>(std::ranges::count_if(
      collection_.scales(), [&](double scale) { return is_within(scale, options); }));
}

void ExactSearch::scan(Candidates& candidates) const {
  for (std::size_t row = 0; row < collection_.size(); ++row) candidates.consider(row);
}

void ExactSearch::visit_index(std::span<const float> query, Candidates& candidates) const {
  const MetricSketch& map = sketches_->map;
  const double margin =
      map.margin(std::max(collection_.largest_magnitude(), magnitude(query, blocks_)));
  std::vector<float> sketch(map.size());
  map.write(query, sketch);
  const SketchList& list = sketches_->list;
  const auto radius = [&] { return candidates.limit() + margin; };
  if (tree_) {
    std::vector<float> place(map.size());
    list.quantiser().locate(sketch, place);
    tree_->visit_within(place, list.reach(radius()), [&](std::size_t row) {
      candidates.consider(row);
      return list.reach(radius());
    });
  } else {
    list.visit_within(
        sketch, radius(), candidates.count(),
        [&](std::size_t row) {
          candidates.consider(row);
          return radius();
        },
        [&](std::size_t row) { collection_.prefetch(row); });
  }
}

void ExactSearch::check_query(std::span<const float> query, const SearchOptions& options) const {
  if (options.count == 0) throw InvalidInput("the number of matches asked for must be at least 1");
  if (collection_.empty()) return;
  if (query.size() != collection_.dimension()) {
    throw InvalidInput("a query of " + std::to_string(query.size()) +
                       " numbers against vectors of " + std::to_string(collection_.dimension()));
  }
  magnitude(query, blocks_);
}

SearchResult ExactSearch::search(std::span<const float> query, const SearchOptions& options) const {
  check_query(query, options);
  Candidates candidates(*this, query, options);
  if (sketches_ && !collection_.empty()) {
    visit_index(query, candidates);
  } else {
    scan(candidates);
  }
  return finish(query, options, candidates);
}

SearchResult ExactSearch::search_among(std::span<const std::size_t> rows,
                                       std::span<const float> query,
                                       const SearchOptions& options) const {
  check_query(query, options);
  Candidates candidates(*this, query, options);
  for (const std::size_t row : rows) candidates.consider(row);
  return finish(query, options, candidates);
}

SearchResult ExactSearch::finish(std::span<const float> query, const SearchOptions& options,
                                 Candidates& candidates) const {
  SearchResult result;
  result.part_names = metric_->part_names();
  result.compared = count_within(options);
  result.examined = candidates.examined();
  const std::vector<Candidate> best = candidates.take();
  if (best.size() >= many_matches) collection_.read_models();
  for (const Candidate& candidate : best) {
    result.matches.push_back(describe(query, candidate, options.differences));
  }
  return result;
}

Match ExactSearch::describe(std::span<const float> query, const Candidate& candidate,
                            std::size_t differences) const {
  const StoredVector model = collection_[candidate.row];
  return {.row = candidate.row,
          .id = model.shape_id,
          .path = std::string(model.path),
          .scale = model.scale,
          .distance = candidate.distance,
          .parts = metric_->parts(query, model.values),
          .differences = largest_differences(*metric_, blocks_, query, model.values, differences),
          .hand = std::nullopt};
}

}  // namespace mdbd
