#pragma once

#include <cstddef>
#include <cstdint>
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

/// A point of groups, by its number in them, and its distance: L1, or the square of L2.
struct GroupedPoint {
  std::uint32_t distance = 0;
  std::uint32_t number = 0;
};

/// Finds the points of groups (SketchList) within a distance of a point of at most 256 bytes.
/// @param limit of the distance: L1, or the square of L2
/// @param found takes them in order; of the size of the groups
/// @returns how many there are
std::size_t find_within(std::span<const std::uint8_t> point, std::span<const std::uint8_t> groups,
                        PointNorm norm, std::uint32_t limit, std::span<GroupedPoint> found);

}  // namespace mdbd
