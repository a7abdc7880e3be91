#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "features/core/ball.h"
#include "features/descriptor/ball_placement.h"
#include "features/descriptor/pair_distances.h"
#include "features/descriptor/solid_harmonics.h"

namespace mdbd {

/// How many of the largest radii the signature holds.
inline constexpr std::size_t fused_radii = 30;

/// Some consecutive numbers of a signature that say one thing.
struct SignaturePart {
  std::string_view name;
  std::size_t first = 0;
  std::size_t count = 0;
  double weight = 1.0;  ///< by which the numbers are multiplied
};

/// The parts of mdbd-fused, in order:
/// - placement: square roots, softened at zero, of ball_placement();
/// - solid: the same of solid_harmonics();
/// - pairs: the same of pair_distances();
/// - radii: the largest radii divided by R, in decreasing order, filled up with zeros;
/// - axes: logarithms of the solid's three principal root mean square extents, the largest first,
///   relative to its root mean square distance from the centroid.
inline constexpr std::array<SignaturePart, 5> fused_parts = [] {
  std::array<SignaturePart, 5> parts{{{"placement", 0, placement_size, 0.032},
                                      {"solid", 0, solid_size, 0.05},
                                      {"pairs", 0, pair_distance_nodes, 0.22},
                                      {"radii", 0, fused_radii, 0.125},
                                      {"axes", 0, 3, 0.055}}};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    parts[i].first = parts[i - 1].first + parts[i - 1].count;
  }
  return parts;
}();

inline constexpr std::size_t fused_size = fused_parts.back().first + fused_parts.back().count;

/// The signature mdbd-fused: sizes of the balls, and where they are. Two signatures are compared by
/// the L1 distance, the sum of the absolute differences, which is a metric; the weights of the
/// parts are folded into the numbers, so that unrelated shapes are at a distance of about 1. It is
/// invariant to rotation, reflection, translation and uniform scale, continuous in the balls, does
/// not depend on their order, and is the same bits for the same balls. docs/signatures.md tells how
/// it was chosen.
/// @param balls disjoint, object units; radii above 0
/// @param scale R, object units, above 0
/// @returns fused_size numbers; zeros if there are no balls
std::vector<float> compute_fused_signature(std::span<const Ball> balls, double scale);

/// What each part contributes to the L1 distance of two signatures; the sum is the distance.
/// @pre f.size() == g.size() == fused_size
std::array<double, fused_parts.size()> fused_part_distances(std::span<const float> f,
                                                            std::span<const float> g);

}  // namespace mdbd
