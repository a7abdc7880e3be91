#pragma once

#include <cstddef>

#include "features/decomposition/preference.h"
#include "features/decomposition/witness.h"

namespace mdbd {

/// Witnesses side by side, for vector instructions.
struct WitnessLanes {
  static constexpr std::size_t capacity = 8;

  std::size_t count = 0;
  double center[3][capacity];
  double radius[capacity];
  const FlatPiece* piece[capacity];

  /// @pre count < capacity
  void add(const Witness& witness) {
    for (int axis = 0; axis < 3; ++axis) center[axis][count] = witness.center[axis];
    radius[count] = witness.radius;
    piece[count] = witness.piece;
    ++count;
  }
};

/// What the ranks (Preference) that witnesses allow are below, over a cube.
struct CubeBounds {
  double smallest;  ///< over all witnesses, of the largest value that each allows
  std::size_t count;
  /// For each witness an affine function of the offset from the centre that is nowhere below the
  /// rank it allows, where that is positive. For a distance its error is of second order in the
  /// size of the cube, and zero above a flat piece.
  double offset[WitnessLanes::capacity];
  double slope[3][WitnessLanes::capacity];
};

/// Bounds the ranks over the axis-aligned cube around a point. Object units.
/// @pre witnesses.count > 0; half_size > 0
CubeBounds bound_over_cube(const WitnessLanes& witnesses, const Preference& preference,
                           const Eigen::Vector3d& center, double half_size);

/// The same for the eight octants of a cube: they share corners, which are measured once.
class OctantBounds {
 public:
  /// @pre witnesses.count > 0; half_size > 0
  OctantBounds(const WitnessLanes& witnesses, const Eigen::Vector3d& center, double half_size);

  /// @param octant bit i is set if it is on the upper side of axis i
  CubeBounds of_octant(int octant, const Preference& preference) const;

 private:
  static constexpr std::size_t nodes = 27;

  Eigen::Vector3d center_;
  double half_size_;
  std::size_t count_;
  /// What the witnesses allow at the nodes of a grid of 3 x 3 x 3 points, x fastest.
  alignas(32) double values_[nodes][WitnessLanes::capacity];
};

}  // namespace mdbd
