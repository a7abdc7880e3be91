#pragma once

#include <cstddef>

#include "features/decomposition/preference.h"
#include "features/decomposition/witness.h"

namespace mdbd {

/// Witnesses as they are seen from the centre of a cube, side by side for vector instructions.
struct WitnessLanes {
  static constexpr std::size_t capacity = 12;

  std::size_t count = 0;
  double center[3][capacity];
  double radius[capacity];
  double slope[3][capacity];  ///< of the distance at the centre of the cube
  const FlatPiece* piece[capacity];

  /// @param slope_at_center of Witness::linearise() at the centre of the cube
  /// @pre count < capacity
  void add(const Witness& witness, const Eigen::Vector3d& slope_at_center) {
    for (int axis = 0; axis < 3; ++axis) {
      center[axis][count] = witness.center[axis];
      slope[axis][count] = slope_at_center[axis];
    }
    radius[count] = witness.radius;
    piece[count] = witness.piece;
    ++count;
  }
};

/// What the ranks (Preference) that witnesses allow are below, over a cube.
struct CubeBounds {
  double smallest;  ///< over all witnesses, of the largest value that each allows
  /// For each witness an affine function of the offset from the centre that is nowhere below the
  /// rank it allows, where that is positive. For a distance its error is of second order in the
  /// size of the cube, and zero above a flat piece.
  double offset[WitnessLanes::capacity];
  double slope[3][WitnessLanes::capacity];
};

/// Bounds the ranks over the axis-aligned cube around a point. Object units.
/// @pre witnesses.count > 0; half_size > 0
CubeBounds bound_over_cube(WitnessLanes& witnesses, const Preference& preference,
                           const Eigen::Vector3d& center, double half_size);

}  // namespace mdbd
