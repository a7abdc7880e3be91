#pragma once

#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// Points of the boundary of a solid. Object units; all coordinates are finite.
struct PointCloud {
  std::vector<Eigen::Vector3d> points;
  /// Empty, or for each point the unit normal there, pointing outward if the file is right.
  std::vector<Eigen::Vector3d> normals;

  bool has_normals() const { return !normals.empty(); }
};

}  // namespace mdbd
