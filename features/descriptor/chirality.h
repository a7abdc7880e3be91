#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "features/core/ball.h"

/// What a shape has that its mirror image has the other way round.
namespace mdbd {

inline constexpr std::size_t chirality_size = 28;

/// Below this length the numbers are those of a shape without a hand: what the decomposition of a
/// symmetric shape leaves of them is 0.003 at most.
inline constexpr double least_chirality = 0.008;

/// How the hands of two shapes go together.
enum class Hand {
  none,      ///< one of the two has none that could be seen
  same,      ///< both are left or both right
  mirrored,  ///< one is left, the other right
  unclear    ///< they differ in more than the hand
};

std::string_view to_string(Hand hand);

/// Numbers that change their sign under reflection, and that nothing else that keeps the shape
/// changes: rotation, translation, uniform scale, order of the balls. They are the pseudo-scalar
/// products of three of the shape's moments of degree 1 (v), 2 (Q) and 3 (T), symmetric and without
/// trace, taken of the balls as points of their volume in the frame of to_solid_frame(), under
/// Gaussians of the width 0.5, 1 and 2 around the origin: det(v1, v2, v3) and, for each two widths
/// a < b and each width u, v_u . axial(Q_a Q_b), T_u : (Q_a x Q_b) and v_u . axial(T_a T_b). Each
/// is divided by the power 2/3 of the product of its factors' lengths, so that it grows as they do
/// and remains continuous. A shape with a plane of symmetry has only zeros; so has, though it is
/// chiral, one whose symmetry leaves none of these products, as a twisted prism of three or more
/// sides.
/// @param balls object units; radii above 0
/// @returns chirality_size numbers; zeros if there are no balls
std::vector<float> compute_chirality(std::span<const Ball> balls);

/// Compares the hands of two shapes by the angle between their numbers.
/// @pre f.size() == g.size() == chirality_size
Hand compare_hands(std::span<const float> f, std::span<const float> g);

}  // namespace mdbd
