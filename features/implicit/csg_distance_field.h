#pragma once

#include <vector>

#include "features/distance/distance_field.h"
#include "features/implicit/creases.h"
#include "features/implicit/csg_solid.h"

namespace mdbd {

/// The distance field of a CSG solid: distances to its boundary, to about 1e-10 of R.
///
/// The value of the solid is a lower bound of the distance. It is the distance where the foot on
/// the surface that decides it lies on the boundary, as is the case inside an intersection of
/// convex things and outside a union. Elsewhere the closest boundary point is the foot on another
/// surface, or lies where surfaces meet (Creases).
class CsgDistanceField final : public DistanceField {
 public:
  /// @throws InvalidInput if the solid is empty, not known to be bounded, or has too many edges
  explicit CsgDistanceField(CsgSolid solid);

  // The creases refer to the solid beside them.
  CsgDistanceField(const CsgDistanceField&) = delete;
  CsgDistanceField& operator=(const CsgDistanceField&) = delete;

  using DistanceField::measure;
  Ball enclosing_ball() const override { return enclosing_ball_; }
  bool is_closed() const override { return true; }
  void measure(std::span<const DistanceQuery> queries,
               std::span<DistanceSample> samples) const override;

 private:
  Ball find_enclosing_ball() const;
  std::vector<Eigen::Vector3d> farthest(const Eigen::Vector3d& x, double bound) const;
  FlatRegion flat_region(std::size_t surface, const Eigen::Vector3d& foot) const;
  DistanceSample measure_point(const Eigen::Vector3d& x, std::vector<double>& distances) const;

  CsgSolid solid_;
  double tolerance_;
  Creases creases_;
  Ball enclosing_ball_;
};

}  // namespace mdbd
