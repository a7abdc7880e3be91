#pragma once

#include <span>

namespace mdbd {

/// The similarity distance of two descriptors (paper, section 5.2) with its two parts.
struct SimilarityDistance {
  double radii = 0.0;  ///< |f_R - g_R|_2
  double walk = 0.0;   ///< |f_P - g_P|_2
  double total = 0.0;  ///< radii + alpha * walk
};

/// The similarity distance of two vectors laid out as Descriptor::values: a metric.
/// @param radius_count k, how many of the values are radii; the others are walk sums
/// @param walk_weight alpha
/// @pre f.size() == g.size() >= radius_count
SimilarityDistance similarity_distance(std::span<const float> f, std::span<const float> g,
                                       int radius_count, double walk_weight);

}  // namespace mdbd
