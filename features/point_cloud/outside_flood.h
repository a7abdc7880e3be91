#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// The space around a cloud that can be reached from far away without coming near to any point: a
/// flood fill on a grid of voxels.
class OutsideFlood {
 public:
  /// @param reach for each point, how near the flood comes to it. Object units.
  /// @pre at least one point; as many reaches as points, all positive
  OutsideFlood(std::span<const Eigen::Vector3d> points, std::span<const double> reach);

  /// Whether the flood came to a place. Object units.
  bool reaches(const Eigen::Vector3d& place) const;

  double voxel_size() const { return voxel_size_; }  ///< object units

 private:
  using Voxel = std::array<int, 3>;
  enum State : std::uint8_t { dry, near_point, flooded };

  Voxel voxel_of(const Eigen::Vector3d& place) const;
  bool contains(const Voxel& voxel) const;
  std::size_t index_of(const Voxel& voxel) const;
  void mark_ball(const Eigen::Vector3d& center, double radius);
  void flood();

  Eigen::Vector3d origin_;
  double voxel_size_;
  Voxel size_;
  std::vector<State> states_;
};

}  // namespace mdbd
