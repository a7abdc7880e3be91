#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mdbd::bench {

/// The squared Euclidean distance of each voxel from the nearest voxel outside, in voxels, exact
/// (Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions, 2012).
/// @param is_inside 1 or 0 for each voxel, x fastest, then y, then z
/// @pre the outermost voxels on all sides are outside; counts of at most 1000
std::vector<float> squared_distance_transform(std::span<const std::uint8_t> is_inside,
                                              const Eigen::Array3i& counts);

}  // namespace mdbd::bench
