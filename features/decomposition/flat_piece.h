#pragma once

#include <vector>

#include <Eigen/Core>

#include "features/core/convex_polygon.h"
#include "features/decomposition/max_min_program.h"

namespace mdbd {

/// Upper bounds of a distance over a cube.
struct DistanceBound {
  double largest;  ///< of all values
  /// With a given slope, of the lowest affine function of the offset from the centre that is
  /// nowhere below the distance.
  double constant;
};

/// A flat convex piece of the boundary, ready for distances: a frame in its plane, and its edges in
/// that frame. Object units.
class FlatPiece {
 public:
  /// @pre the polygon has an area
  explicit FlatPiece(ConvexPolygon polygon);

  /// The distance of a point from the piece and its gradient, zero on the piece.
  AffineFunction linearise(const Eigen::Vector3d& x) const;

  /// Bounds the distance over the axis-aligned cube around x.
  DistanceBound bound_over_cube(const Eigen::Vector3d& x, double half_size,
                                const Eigen::Vector3d& slope) const;

 private:
  /// An edge in the frame; the inside is to its left.
  struct Edge {
    double x;
    double y;
    double along_x;  // unit vector
    double along_y;
    double length;
  };

  Eigen::Vector3d origin_;
  Eigen::Vector3d first_;   // unit vectors in the plane …
  Eigen::Vector3d second_;
  Eigen::Vector3d normal_;  // … and across
  std::vector<Edge> edges_;
};

}  // namespace mdbd
