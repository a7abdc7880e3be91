#include "evaluation/measures/classification.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evaluation/measures/statistics.h"
#include "features/core/random.h"

namespace mdbd {
namespace {

constexpr double validation_share = 0.15;
constexpr double test_share = 0.15;

std::size_t share_of(double share, std::size_t models) {
  return static_cast<std::size_t>(std::lround(share * static_cast<double>(models)));
}

}  // namespace

std::vector<Part> split_at_random(std::size_t models, std::uint64_t seed) {
  const std::size_t validation = share_of(validation_share, models);
  const std::size_t test = share_of(test_share, models);
  std::vector<Part> parts(models, Part::training);
  std::fill_n(parts.begin(), validation, Part::validation);
  std::fill_n(parts.begin() + static_cast<std::ptrdiff_t>(validation), test, Part::test);
  Random random(seed);
  for (std::size_t i = models; i > 1; --i) std::swap(parts[i - 1], parts[random.index(i)]);
  return parts;
}

ConfusionCounts count_confusions(std::span<const std::size_t> labels,
                                 std::span<const std::size_t> predicted,
                                 std::span<const Part> parts, std::optional<Part> part,
                                 std::size_t class_count) {
  ConfusionCounts counts(class_count, std::vector<std::size_t>(class_count, 0));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!part || parts[i] == *part) ++counts[labels[i]][predicted[i]];
  }
  return counts;
}

void add_counts(ConfusionCounts& sum, const ConfusionCounts& counts) {
  for (std::size_t row = 0; row < counts.size(); ++row) {
    for (std::size_t column = 0; column < counts[row].size(); ++column) {
      sum[row][column] += counts[row][column];
    }
  }
}

double accuracy(const ConfusionCounts& counts) {
  std::size_t right = 0;
  std::size_t all = 0;
  for (std::size_t row = 0; row < counts.size(); ++row) {
    right += counts[row][row];
    for (const std::size_t count : counts[row]) all += count;
  }
  return static_cast<double>(right) / static_cast<double>(all);
}

Spread spread_of(std::span<const double> values) {
  const auto [lowest, highest] = std::ranges::minmax(values);
  Spread spread{.mean = mean(values), .deviation = 0.0, .lowest = lowest, .highest = highest};
  if (values.size() < 2) return spread;
  double squares = 0.0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return spread;
}

}  // namespace mdbd
