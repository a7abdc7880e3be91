#pragma once

#include "features/distance/dipole_winding_number.h"
#include "features/distance/distance_field.h"
#include "features/distance/point_tree.h"
#include "features/point_cloud/oriented_cloud.h"

namespace mdbd {

/// The distance field of a point cloud: exact distances to the points; a place is inside where the
/// winding number of the oriented points is above one half.
///
/// Between samples the sign changes away from the points, so the field is never closed, and what it
/// says holds for balls that are larger than the spacing only.
class PointCloudDistanceField final : public DistanceField {
 public:
  /// @pre at least one point
  /// @throws InvalidInput if all points coincide
  explicit PointCloudDistanceField(const OrientedCloud& cloud);

  // The winding number refers to the tree beside it.
  PointCloudDistanceField(const PointCloudDistanceField&) = delete;
  PointCloudDistanceField& operator=(const PointCloudDistanceField&) = delete;

  using DistanceField::measure;
  Ball enclosing_ball() const override { return enclosing_ball_; }
  Eigen::Vector3d centroid() const override { return centroid_; }  ///< the mean of the points
  bool is_closed() const override { return false; }
  void measure(std::span<const DistanceQuery> queries,
               std::span<DistanceSample> samples) const override;

 private:
  Ball enclosing_ball_;
  Eigen::Vector3d centroid_;
  PointTree tree_;
  DipoleWindingNumber winding_number_;
};

}  // namespace mdbd
