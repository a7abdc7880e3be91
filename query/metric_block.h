#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace mdbd {

/// The length of a difference of vectors.
enum class PointNorm {
  l1,  ///< sum of the absolute values
  l2   ///< Euclidean
};

/// Consecutive numbers of a vector, and what they add to a distance: weight * |f - g|. The
/// distances that answers are ordered by are sums over blocks.
struct MetricBlock {
  std::size_t first = 0;
  std::size_t count = 0;
  double weight = 1.0;  ///< at least 0
  PointNorm norm = PointNorm::l2;
};

/// How far rounding may move a distance in single precision, relatively, at most. What a number
/// adds goes through an addition for every eight numbers and fifteen more, each of which rounds by
/// half an epsilon at most.
constexpr double single_precision_margin(std::size_t numbers) {
  constexpr double epsilon = std::numeric_limits<float>::epsilon();
  return epsilon * (static_cast<double>(numbers) + 8.0);
}

/// The distance of two vectors in single precision, within single_precision_margin() of the true
/// one.
/// @pre the blocks lie within both vectors, and no component exceeds
///      MetricSketch::largest_component
double block_distance(std::span<const float> f, std::span<const float> g,
                      std::span<const MetricBlock> blocks);

/// The L1 distances, or the squares of the L2 distances, in single precision of a point from those
/// of groups (SketchList), `distances.size()` of them, within single_precision_margin() of 8 times
/// as many numbers of the true ones.
void grouped_distances(std::span<const float> point, std::span<const float> groups, PointNorm norm,
                       std::span<float> distances);

}  // namespace mdbd
