#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "features/core/ball.h"

namespace mdbd {

/// The nodes between which pairs are shared by their distance: 0, 0.25 … 4.
inline constexpr std::size_t pair_distance_nodes = 17;

/// How far parts of the shape lie from each other: the distribution of the distance of two balls
/// (after the D2 of Osada, Funkhouser, Chazelle, Dobkin, Shape Distributions, 2002), each drawn
/// with a chance proportional to its radius. Of two balls it is the root mean square distance of a
/// point in the one and a point in the other, which is known in closed form; a ball makes a pair
/// with itself, too. Continuous in the balls; rigid motion and reflection do not change it.
/// @param balls in the frame of to_solid_frame()
/// @returns the share of each node; they sum to 1
std::vector<double> pair_distances(std::span<const Ball> balls);

}  // namespace mdbd
