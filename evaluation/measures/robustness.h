#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "evaluation/measures/vector_distance.h"

/// How well models are found again after a change: noise, another pose, fewer faces (paper,
/// section 5.2, Figure 13). Every changed model is a query to the collection of the unchanged ones.
/// "Distance" is that of the signature.
namespace mdbd {

/// Descriptors are vectors of one signature.
struct RobustnessInput {
  std::vector<std::vector<float>> clean;                  ///< of each model
  std::vector<std::string> labels;                        ///< the class of each model
  std::vector<std::optional<std::vector<float>>> varied;  ///< after the change; empty if it failed
  std::vector<DistanceTerm> terms;                        ///< of the distance
};

/// How one changed model fared.
struct ModelRobustness {
  std::size_t model = 0;  ///< its index
  /// The rank of the model itself in the answer, from 1: one more than the models that are strictly
  /// nearer. A model and its duplicates, which are equally near, share a rank.
  std::size_t self_rank = 0;
  /// Whether the nearest model, without the model itself, is of its class; of several equally near
  /// ones the first counts. Empty if the model is alone in its class.
  std::optional<bool> is_class_found;
  /// Spearman's correlation of the distances to all other models, after the change and before.
  /// Empty if there are fewer than two others or all distances are equal.
  std::optional<double> rank_correlation;
  double displacement = 0.0;  ///< distance to the model itself
  /// Displacement relative to the distance, before the change, to the nearest other model that is
  /// no duplicate of it, that is, at a distance above 0. Empty if there is none.
  std::optional<double> relative_displacement;
};

/// Rates are from 0 to 1. What is empty could be told of no model.
struct Robustness {
  std::vector<ModelRobustness> models;   ///< those whose changed copy could be described
  double self_first = 0.0;               ///< rate of self_rank 1
  std::optional<double> class_accuracy;  ///< rate of is_class_found
  std::optional<double> rank_correlation_mean;
  std::optional<double> rank_correlation_min;
  std::optional<double> displacement_median;  ///< of relative_displacement, like the next two
  std::optional<double> displacement_mean;
  std::optional<double> displacement_90;  ///< 90 % of the models lie below
  std::vector<double> mean_shift;         ///< of each number of the descriptor: after - before
  std::vector<double> mean_absolute_shift;
};

/// The distances of a descriptor to some others.
std::vector<double> distances_to(std::span<const std::vector<float>> others,
                                 const std::vector<float>& descriptor,
                                 std::span<const DistanceTerm> terms);

/// @throws InvalidInput if the sizes differ or no changed model was described
Robustness measure_robustness(const RobustnessInput& input);

}  // namespace mdbd
