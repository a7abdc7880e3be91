#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "features/alignment/align_shapes.h"

namespace mdbd {

/// A surface point of one shape that lies beside the surface of the other one.
struct PointError {
  Eigen::Vector3d point;     ///< where it was laid; in units of the second shape
  Eigen::Vector3d gradient;  ///< of the error, if the first shape moves there; of length 1 or 0
  double error = 0.0;        ///< the distance beyond the resolution, relative to R of the second
};

/// Points of the surfaces of two shapes, to be laid upon the other surface.
class SurfaceOverlay {
 public:
  /// @param balls of each shape at which points are taken, two at each; as many are taken all
  /// around
  SurfaceOverlay(const PackedShape& first, const PackedShape& second, std::size_t balls);

  /// The errors of all points, after a motion of the first shape.
  std::vector<PointError> measure(const Similarity& motion) const;

  /// The best motion near a given one, by least squares.
  Similarity refine(const Similarity& motion) const;

 private:
  void measure_first(const Similarity& motion, std::vector<PointError>& errors) const;
  void measure_second(const Similarity& motion, std::vector<PointError>& errors) const;
  Similarity step(const Similarity& motion, const std::vector<PointError>& errors,
                  double damping) const;

  PackedShape first_;
  PackedShape second_;
  Ball unit_;  // about the second: errors and steps are relative to it
  std::vector<Eigen::Vector3d> first_points_;
  std::vector<Eigen::Vector3d> second_points_;
};

/// The largest error.
double largest_error(const std::vector<PointError>& errors);

}  // namespace mdbd
