#pragma once

#include <vector>

#include <Eigen/Core>

#include "features/core/convex_polygon.h"
#include "features/decomposition/max_min_program.h"

namespace mdbd {

/// A flat convex piece of the boundary, ready for distances: a frame in its plane, and its edges in
/// that frame. Object units.
class FlatPiece {
 public:
  /// @pre the polygon has an area
  explicit FlatPiece(ConvexPolygon polygon);

  /// The distance of a point from the piece and its gradient, zero on the piece.
  /// @param margin the piece counts as so much larger: where x lies above its plane no farther from
  ///        it, the distance is that from the plane
  AffineFunction linearise(const Eigen::Vector3d& x, double margin = 0.0) const;

  /// Measures the distances of the corners of an axis-aligned cube, x fastest: 8 values.
  void measure_corners(const Eigen::Vector3d& lowest, double size, double* distances) const;

  /// Measures the distances of the corners of the octants of a cube: a grid of 3 x 3 x 3 points,
  /// `step` apart, x fastest.
  void measure_octants(const Eigen::Vector3d& lowest, double step, double* distances) const;

 private:
  /// An edge in the frame; the inside is to its left.
  struct Edge {
    double x;
    double y;
    double along_x;  // unit vector
    double along_y;
    double length;
  };

  template <int side>
  void measure_grid(const Eigen::Vector3d& lowest, double step, double* distances) const;

  Eigen::Vector3d origin_;
  Eigen::Vector3d first_;  // unit vectors in the plane …
  Eigen::Vector3d second_;
  Eigen::Vector3d normal_;  // … and across
  std::vector<Edge> edges_;
};

}  // namespace mdbd
