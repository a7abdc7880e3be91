#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// Rotations to begin a search from: the 24 that carry the axes to the axes, then `count` that
/// cover all rotations evenly (Alexa, Super-Fibonacci Spirals: Fast, Low-Discrepancy Sampling of
/// SO(3), CVPR 2022). 600 leave no rotation further than some 25 degrees from one of them.
std::vector<Eigen::Matrix3d> trial_rotations(std::size_t count);

}  // namespace mdbd
