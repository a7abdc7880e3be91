#pragma once

#include "features/distance/mesh_distance_field.h"
#include "features/planar/planar_domain.h"

namespace mdbd {

/// The distance field of a domain in the plane z = 0: exact distances to its outlines. They are
/// measured to the walls of the prism that stands on the domain, far above and below the plane, so
/// that a side is a flat piece of the boundary as a face is one in space.
class PlanarDistanceField final : public DistanceField {
 public:
  /// @pre the outlines are as simplify() makes them
  explicit PlanarDistanceField(const PlanarDomain& domain);

  using DistanceField::measure;
  Ball enclosing_ball() const override { return enclosing_ball_; }
  Eigen::Vector3d centroid() const override { return centroid_; }
  int dimension() const override { return 2; }
  bool is_closed() const override { return true; }
  void measure(std::span<const DistanceQuery> queries,
               std::span<DistanceSample> samples) const override;

 private:
  Ball enclosing_ball_;
  Eigen::Vector3d centroid_;  // of the outlines
  MeshDistanceField walls_;
};

}  // namespace mdbd
