#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// Values at the points of a grid.
struct VoxelGrid {
  std::array<std::size_t, 3> size = {0, 0, 0};          ///< points along each axis
  std::vector<double> values;                           ///< the first axis runs fastest
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();     ///< of the first point, object units
  Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();  ///< columns: from a point to the next
};

}  // namespace mdbd
