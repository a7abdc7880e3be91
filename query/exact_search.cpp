#include "query/exact_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "features/core/errors.h"

namespace mdbd {
namespace {

double norm(std::span<const float> values) {
  double sum = 0.0;
  for (const float value : values) sum += static_cast<double>(value) * value;
  return std::sqrt(sum);
}

// The k smallest of the numbers added, of which the largest is asked for.
class SmallestTotals {
 public:
  explicit SmallestTotals(std::size_t k) : k_(k) {}

  void add(double total) {
    totals_.push(total);
    if (totals_.size() > k_) totals_.pop();
  }

  double kth() const {
    return totals_.size() < k_ ? std::numeric_limits<double>::infinity() : totals_.top();
  }

 private:
  std::size_t k_;
  std::priority_queue<double> totals_;
};

/// The numbers that differ the most, as points, where what a number weighs is part of it.
std::vector<NumberDifference> largest_differences(const SignatureMetric& metric,
                                                  std::span<const float> query,
                                                  std::span<const float> match, std::size_t count) {
  const std::vector<float> f = metric.point(query);
  const std::vector<float> g = metric.point(match);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f[i] != g[i]) order.push_back(i);
  }
  count = std::min(count, order.size());
  std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(count), {},
                            [&](std::size_t i) { return std::pair(-std::abs(f[i] - g[i]), i); });
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

ExactSearch::ExactSearch(std::vector<StoredVector> collection,
                         std::unique_ptr<const SignatureMetric> metric)
    : collection_(std::move(collection)),
      metric_(std::move(metric)),
      neighbours_(index_collection()) {
  for (const StoredVector& vector : collection_) {
    largest_norm_ = std::max(largest_norm_, norm(metric_->point(vector.values)));
  }
}

NearestNeighbours ExactSearch::index_collection() const {
  const std::size_t dimension = collection_.empty() ? 1 : collection_.front().values.size();
  std::vector<float> values;
  values.reserve(collection_.size() * dimension);
  for (const StoredVector& vector : collection_) {
    if (vector.values.size() != dimension || vector.values.size() < metric_->least_size()) {
      throw InvalidInput(vector.path + ": its vector has " + std::to_string(vector.values.size()) +
                         " numbers, which does not fit the collection");
    }
    const std::vector<float> row = metric_->point(vector.values);
    values.insert(values.end(), row.begin(), row.end());
  }
  return {std::move(values), dimension, metric_->norm()};
}

// What the distance of a vector whose point is at this distance is at least, rounding considered.
// The norm is a sum in single precision: its relative error is below half of `relative`. A point
// may be rounded by half an epsilon of its norm, whatever their difference is.
double ExactSearch::lower_bound(double point_distance, double query_norm) const {
  constexpr double epsilon = std::numeric_limits<float>::epsilon();
  const double relative = epsilon * static_cast<double>(collection_.front().values.size() + 8);
  return point_distance * (1.0 - relative) - epsilon * (query_norm + largest_norm_);
}

SearchResult ExactSearch::search(std::span<const float> query, std::size_t k,
                                 std::size_t differences) const {
  if (k == 0) throw InvalidInput("the number of matches asked for must be at least 1");
  SearchResult result;
  result.collection_size = collection_.size();
  result.exact = collection_.empty();
  const std::size_t count = std::min(k, collection_.size());
  result.part_names = metric_->part_names();
  const std::vector<float> point = metric_->point(query);
  const double query_norm = norm(point);
  std::vector<Candidate> candidates;
  SmallestTotals smallest(count);
  for (std::size_t batch = count; !result.exact; batch *= 2) {
    const std::vector<Neighbour> neighbours = neighbours_.search(point, batch);
    for (std::size_t i = candidates.size(); i < neighbours.size() && !result.exact; ++i) {
      // Strictly above, so that a model at the same distance is not missed: ties go by path.
      if (lower_bound(neighbours[i].distance, query_norm) > smallest.kth()) {
        result.exact = true;
      } else {
        candidates.push_back(examine(query, neighbours[i].row));
        smallest.add(candidates.back().distance);
      }
    }
    result.exact = result.exact || candidates.size() == collection_.size();
  }
  result.examined = candidates.size();
  result.matches = best_matches(query, std::move(candidates), count, differences);
  return result;
}

ExactSearch::Candidate ExactSearch::examine(std::span<const float> query, std::size_t row) const {
  return {row, metric_->distance(query, collection_[row].values)};
}

std::vector<Match> ExactSearch::best_matches(std::span<const float> query,
                                             std::vector<Candidate> candidates, std::size_t count,
                                             std::size_t differences) const {
  const auto is_better = [&](const Candidate& a, const Candidate& b) {
    if (a.distance != b.distance) return a.distance < b.distance;
    return collection_[a.row].path < collection_[b.row].path;
  };
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
                    candidates.end(), is_better);
  candidates.resize(count);
  std::vector<Match> matches;
  matches.reserve(count);
  for (const Candidate& candidate : candidates) {
    const StoredVector& model = collection_[candidate.row];
    matches.push_back(
        {.id = model.shape_id,
         .path = model.path,
         .scale = model.scale,
         .distance = candidate.distance,
         .parts = metric_->parts(query, model.values),
         .differences = largest_differences(*metric_, query, model.values, differences),
         .hand = std::nullopt});
  }
  return matches;
}

}  // namespace mdbd
