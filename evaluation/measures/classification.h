#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace mdbd {

/// What a model is used for in one run of a classification.
enum class Part : std::uint8_t { training, validation, test };

/// Divides models at random into 70 % for training, 15 % for validation and 15 % for the test
/// (paper, section 5.3), without regard to their classes; validation and test are rounded.
std::vector<Part> split_at_random(std::size_t models, std::uint64_t seed);

/// Counts by true class (rows) and predicted class (columns).
using ConfusionCounts = std::vector<std::vector<std::size_t>>;

/// Counts the models of one part, or of all parts if there is none.
/// @pre the three have one size; labels and predictions are below class_count
ConfusionCounts count_confusions(std::span<const std::size_t> labels,
                                 std::span<const std::size_t> predicted,
                                 std::span<const Part> parts, std::optional<Part> part,
                                 std::size_t class_count);

/// Adds the counts of another run. @pre both have one size
void add_counts(ConfusionCounts& sum, const ConfusionCounts& counts);

/// The share of the models counted whose prediction is right. @pre there are any
double accuracy(const ConfusionCounts& counts);

/// How the results of several runs lie.
struct Spread {
  double mean = 0.0;
  double deviation = 0.0;  ///< of the sample; 0 for a single run
  double lowest = 0.0;
  double highest = 0.0;
};

/// @pre values is not empty
Spread spread_of(std::span<const double> values);

}  // namespace mdbd
