#pragma once

#include <span>

#include "features/alignment/similarity.h"
#include "features/core/ball.h"
#include "features/distance/distance_field.h"

namespace mdbd {

/// A shape with its balls.
struct PackedShape {
  const DistanceField& field;   ///< of dimension 3
  std::span<const Ball> balls;  ///< of its decomposition, object units; at least one
  /// Distances to the boundary up to this say nothing, as those between the samples of a point
  /// cloud; object units.
  double resolution = 0.0;
};

/// How one shape can be laid upon another.
struct Alignment {
  Similarity motion;  ///< from the object units of the first shape to those of the second
  /// The largest distance of a point of either surface from the other one, beyond the resolution of
  /// that; relative to R of the second shape. Of some 4,000 points if it is within the tolerance.
  double deviation = 0.0;
};

/// Looks for a motion, of any scale and also with a reflection, that lays the first shape upon the
/// second so well that nowhere their surfaces deviate by more than a tolerance. The search begins
/// where balls of the one lie in balls of the other and ends with least squares of the distances of
/// surface points in both directions, as in the iterative closest point method (Chen and Medioni,
/// Object modelling by registration of multiple range images, 1992), but without linear search or
/// normals: it needs distances alone, so that shapes of different representations can be compared.
///
/// Deterministic. Takes some 10,000 distance queries where there is such a motion, and ten times as
/// many where there is none.
///
/// @param tolerance relative to R of the second shape, above 0
/// @returns the first motion within the tolerance; if none was found, the best one of few points
Alignment align_shapes(const PackedShape& first, const PackedShape& second, double tolerance);

}  // namespace mdbd
