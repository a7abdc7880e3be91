#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "query/metric_block.h"

namespace mdbd {

/// Puts points on a cubic lattice of 256 steps in each direction: a byte a number. The step is the
/// same for all numbers, so that distances of bytes are distances of points, in steps.
///
/// The lattice spans the bulk of the points. Those outside are moved to its faces first, which
/// takes no two points further apart; after that a point is half a step from its bytes at most.
class ScalarQuantiser {
 public:
  /// @param points one after the other, `dimension` finite numbers each; at least one
  ScalarQuantiser(std::span<const float> points, std::size_t dimension);

  /// What step() and corner() of another one gave.
  ScalarQuantiser(double step, std::vector<double> corner)
      : step_(step), corner_(std::move(corner)) {}

  double step() const { return step_; }
  std::span<const double> corner() const { return corner_; }

  /// The place of a point in the lattice, in steps from its corner; 0 to 255. Two places are at
  /// most as far apart as their points, but for rounding().
  /// @param place of the size of the point
  void locate(std::span<const float> point, std::span<float> place) const;

  /// How far, in steps, places may be further apart than their points by either norm, at most:
  /// they are in single precision.
  double rounding() const;

  /// Writes the bytes nearest to a place.
  /// @returns how far they are from it, in steps
  static double write(std::span<const float> place, PointNorm norm, std::span<std::uint8_t> bytes);

 private:
  double step_;
  std::vector<double> corner_;
};

}  // namespace mdbd
