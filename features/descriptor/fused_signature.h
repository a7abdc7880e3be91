#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "features/core/ball.h"
#include "features/descriptor/ball_surroundings.h"
#include "features/descriptor/solid_harmonics.h"

namespace mdbd {

/// Some consecutive numbers of a signature that say one thing.
struct SignaturePart {
  std::string_view name;
  std::size_t first = 0;
  std::size_t count = 0;
  double weight = 1.0;  ///< by which the numbers are multiplied
};

/// The parts of mdbd-fused, in order; all are square roots, softened at zero:
/// - solid: of solid_harmonics();
/// - near, bulk, wide, whole: of ball_surroundings().
inline constexpr std::array<SignaturePart, 1 + surroundings_kinds.size()> fused_parts = [] {
  constexpr std::array<double, surroundings_kinds.size()> weights{0.084, 0.08, 0.06, 0.05};
  std::array<SignaturePart, 1 + surroundings_kinds.size()> parts{{{"solid", 0, solid_size, 0.036}}};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    parts[i] = {surroundings_kinds[i - 1].name, parts[i - 1].first + parts[i - 1].count,
                surroundings_size, weights[i - 1]};
  }
  return parts;
}();

inline constexpr std::size_t fused_size = fused_parts.back().first + fused_parts.back().count;

/// The signature mdbd-fused: where the balls are, and what each of them lies in. Two signatures are
/// compared by the L1 distance, the sum of the absolute differences, which is a metric; the weights
/// of the parts are folded into the numbers, so that unrelated shapes are at a distance of about 1.
/// It is invariant to rotation, reflection, translation and uniform scale, continuous in the balls,
/// does not depend on their order, and is the same bits for the same balls. docs/signatures.md
/// tells how it was chosen.
/// @param balls disjoint, object units; radii above 0
/// @returns fused_size numbers; zeros if there are no balls
std::vector<float> compute_fused_signature(std::span<const Ball> balls);

/// What each part contributes to the L1 distance of two signatures; the sum is the distance.
/// @pre f.size() == g.size() == fused_size
std::array<double, fused_parts.size()> fused_part_distances(std::span<const float> f,
                                                            std::span<const float> g);

}  // namespace mdbd
