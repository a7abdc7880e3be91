#include "evaluation/measures/robustness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluation/measures/statistics.h"
#include "features/core/errors.h"

namespace mdbd {
namespace {

void require_consistent(const RobustnessInput& input) {
  const std::size_t size = input.clean.size();
  if (input.labels.size() != size || input.varied.size() != size) {
    throw InvalidInput("robustness: models, classes and changed models differ in number");
  }
  const auto is_described = [](const auto& descriptor) { return descriptor.has_value(); };
  if (std::ranges::none_of(input.varied, is_described)) {
    throw InvalidInput("robustness: no changed model could be described");
  }
  const std::size_t length = input.clean.front().size();
  const auto has_length = [&](const std::vector<float>& d) { return d.size() == length; };
  if (!std::ranges::all_of(input.clean, has_length) ||
      !std::ranges::all_of(input.varied, [&](const auto& d) { return !d || has_length(*d); })) {
    throw InvalidInput("robustness: descriptors differ in length");
  }
}

std::vector<double> without(std::vector<double> values, std::size_t index) {
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(index));
  return values;
}

/// The nearest model but one, the first of several; that one if there is no other.
std::size_t nearest_other(const std::vector<double>& distances, std::size_t model) {
  std::size_t nearest = model;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (i != model && (nearest == model || distances[i] < distances[nearest])) nearest = i;
  }
  return nearest;
}

std::optional<double> relative_to_neighbours(double displacement,
                                             const std::vector<double>& clean_distances) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double distance : clean_distances) {
    if (distance > 0) nearest = std::min(nearest, distance);
  }
  if (std::isinf(nearest)) return std::nullopt;
  return displacement / nearest;
}

ModelRobustness measure_model(const RobustnessInput& input, std::size_t model) {
  const auto to_all = [&](const std::vector<float>& descriptor) {
    return distances_to(input.clean, descriptor, input.terms);
  };
  const std::vector<double> before = to_all(input.clean[model]);
  const std::vector<double> after = to_all(*input.varied[model]);
  ModelRobustness result;
  result.model = model;
  result.displacement = after[model];
  result.self_rank = 1 + static_cast<std::size_t>(std::ranges::count_if(
                             after, [&](double distance) { return distance < after[model]; }));
  if (std::ranges::count(input.labels, input.labels[model]) > 1) {
    result.is_class_found = input.labels[nearest_other(after, model)] == input.labels[model];
  }
  result.rank_correlation = rank_correlation(without(before, model), without(after, model));
  result.relative_displacement = relative_to_neighbours(result.displacement, before);
  return result;
}

/// One field of the models, where it is not empty.
template <typename Value>
std::vector<double> collect(const std::vector<ModelRobustness>& models,
                            std::optional<Value> ModelRobustness::*field) {
  std::vector<double> values;
  for (const ModelRobustness& model : models) {
    if (model.*field) values.push_back(static_cast<double>(*(model.*field)));
  }
  return values;
}

void summarise(Robustness& result) {
  const std::vector<ModelRobustness>& models = result.models;
  const auto first = std::ranges::count(models, std::size_t{1}, &ModelRobustness::self_rank);
  result.self_first = static_cast<double>(first) / static_cast<double>(models.size());
  if (const auto found = collect(models, &ModelRobustness::is_class_found); !found.empty()) {
    result.class_accuracy = mean(found);
  }
  if (const auto all = collect(models, &ModelRobustness::rank_correlation); !all.empty()) {
    result.rank_correlation_mean = mean(all);
    result.rank_correlation_min = std::ranges::min(all);
  }
  if (const auto all = collect(models, &ModelRobustness::relative_displacement); !all.empty()) {
    result.displacement_median = quantile(all, 0.5);
    result.displacement_mean = mean(all);
    result.displacement_90 = quantile(all, 0.9);
  }
}

void add_shifts(const RobustnessInput& input, Robustness& result) {
  const std::size_t length = input.clean.front().size();
  const auto count = static_cast<double>(result.models.size());
  result.mean_shift.assign(length, 0.0);
  result.mean_absolute_shift.assign(length, 0.0);
  for (const ModelRobustness& model : result.models) {
    for (std::size_t i = 0; i < length; ++i) {
      const double shift = static_cast<double>((*input.varied[model.model])[i]) -
                           static_cast<double>(input.clean[model.model][i]);
      result.mean_shift[i] += shift / count;
      result.mean_absolute_shift[i] += std::abs(shift) / count;
    }
  }
}

}  // namespace

std::vector<double> distances_to(std::span<const std::vector<float>> others,
                                 const std::vector<float>& descriptor,
                                 std::span<const DistanceTerm> terms) {
  std::vector<double> distances;
  distances.reserve(others.size());
  for (const std::vector<float>& other : others) {
    distances.push_back(vector_distance(descriptor, other, terms));
  }
  return distances;
}

Robustness measure_robustness(const RobustnessInput& input) {
  require_consistent(input);
  Robustness result;
  for (std::size_t i = 0; i < input.varied.size(); ++i) {
    if (input.varied[i]) result.models.push_back(measure_model(input, i));
  }
  summarise(result);
  add_shifts(input, result);
  return result;
}

}  // namespace mdbd
