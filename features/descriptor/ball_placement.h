#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "features/core/ball.h"

/// Where the balls of each size lie.
namespace mdbd {

/// The nodes between which balls are shared by the distance of their centre from the origin …
inline constexpr int placement_distances = 7;  ///< 0, 0.5 … 3
/// … and by their radius …
inline constexpr int placement_radii = 4;  ///< 1/64, 1/16, 1/4, 1
/// … and the highest degree of the harmonics that tell the directions they lie in.
inline constexpr int placement_degree = 5;

inline constexpr std::size_t placement_size =
    std::size_t{placement_distances} * placement_radii * (placement_degree + 1);

/// The balls as a distribution over distance, size and direction, each with the weight r^2 (its
/// surface): for each node of distance and of radius the directions of its balls make a function on
/// the sphere, of which the amplitude in each degree of the spherical harmonics is taken, the root
/// of its energy; no rotation or reflection changes it. A ball is seen as a spot of its own size, a
/// Gaussian with the ball's second moment, and so as no direction at all at the origin: everything
/// is continuous in the balls.
/// @param balls in the frame of to_solid_frame()
/// @returns at [(d * placement_radii + r) * (placement_degree + 1) + l] the amplitude of degree l
///          of the balls at node d of distance and node r of radius; for l = 0 it is their share of
///          the weight, no other exceeds sqrt(2l + 1) of that
std::vector<double> ball_placement(std::span<const Ball> balls);

}  // namespace mdbd
