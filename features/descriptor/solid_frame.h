#pragma once

#include <span>
#include <vector>

#include "features/core/ball.h"

namespace mdbd {

/// Moves the centroid of the solid that disjoint balls fill to the origin and scales it so that its
/// root mean square distance from there is 1: the frame in which shapes of any position and size
/// can be compared. It depends continuously on the balls.
/// @pre there is a ball, and all radii are above 0
std::vector<Ball> to_solid_frame(std::span<const Ball> balls);

}  // namespace mdbd
