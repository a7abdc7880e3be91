#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "evaluation/distance_matrix.h"

namespace mdbd {

enum class VectorNorm {
  l1,         ///< sum of |a_i - b_i|
  l2,         ///< root of the sum of (a_i - b_i)^2
  chi_square  ///< sum of (a_i - b_i)^2 / (a_i + b_i) where a_i + b_i > 0; for histograms
};

/// "l1", "l2", "chi_square"
std::string_view to_string(VectorNorm norm);

/// One term of a distance between vectors: a norm over some of their numbers.
struct DistanceTerm {
  VectorNorm norm = VectorNorm::l2;
  std::size_t first = 0;
  std::size_t count = 0;
  double weight = 1.0;
};

/// The sum of the weighted terms.
/// @pre both vectors hold the numbers of all terms
double vector_distance(std::span<const float> a, std::span<const float> b,
                       std::span<const DistanceTerm> terms);

DistanceMatrix vector_distances(std::span<const std::vector<float>> vectors,
                                std::span<const DistanceTerm> terms);

}  // namespace mdbd
