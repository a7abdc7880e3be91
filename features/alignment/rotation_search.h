#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "features/alignment/similarity.h"
#include "features/core/ball.h"

namespace mdbd {

/// Motions that may lay one shape upon another, from their balls alone: the solids that they fill
/// are centred, scaled to the same extent and turned so that balls of the first lie in balls of the
/// second, as deep as their radii ask for. Mirrored ones, too.
class RotationSearch {
 public:
  /// @param first, second disjoint balls, at least one each
  RotationSearch(std::span<const Ball> first, std::span<const Ball> second);

  /// The best of rotations that cover them all, the best first.
  std::vector<Similarity> likely() const;

  /// The best rotations around those, no two of them the same, the best first. It takes longer, and
  /// finds what fits in a narrow range of angles only.
  std::vector<Similarity> polished() const;

 private:
  /// A rotation from one frame to the other, perhaps with a reflection.
  struct Trial {
    double misfit = 0.0;
    Eigen::Matrix3d rotation;
  };

  /// Balls, one array for each number.
  struct BallArrays {
    Eigen::ArrayXf x, y, z, radius;
  };

  static BallArrays to_arrays(std::span<const Ball> balls, const Similarity& frame);
  double misfit(const Eigen::Matrix3d& rotation) const;
  Trial polish(Trial trial) const;
  std::vector<Similarity> to_motions(std::vector<Trial> trials) const;

  Similarity first_frame_;
  Similarity second_frame_;
  std::vector<Ball> first_;    // some balls, in its frame
  BallArrays second_;          // all balls, in its frame
  std::vector<Trial> trials_;  // the best first
};

}  // namespace mdbd
