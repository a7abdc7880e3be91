#pragma once

#include <cstddef>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "bench/rival/voxel_grid.h"
#include "features/core/ball.h"

namespace mdbd::bench {

/// For each voxel an estimate of the largest ball around its centre that is inside the solid and
/// clear of the balls placed. Object units.
class CandidateGrid {
 public:
  struct Voxel {
    std::size_t index;
    float value;
  };

  /// @param values the estimates before any ball is placed; 0 outside
  CandidateGrid(const VoxelGrid& grid, std::vector<float> values);

  /// The voxel with the largest value, or none if no value is above `least`.
  std::optional<Voxel> find_largest(float least);

  /// Lowers the value of a voxel.
  void limit(const Voxel& voxel, float value);

  /// Lowers the values around a ball to the distance from it.
  /// @param largest no value in the grid is larger
  void place(const Ball& ball, double largest);

 private:
  std::span<float> row(std::size_t number);
  void place_in_row(std::size_t number, const Eigen::Vector3d& center, double radius, double reach);

  VoxelGrid grid_;
  std::vector<float> values_;
  /// Rows by the largest value they had when they were last looked at; values only fall.
  std::priority_queue<std::pair<float, std::size_t>> rows_;
};

}  // namespace mdbd::bench
