#pragma once

#include <vector>

#include "evaluation/certificate/mesh_measure.h"
#include "evaluation/certificate/recheck.h"
#include "features/core/random.h"

namespace mdbd {

/// Looks for balls that fit inside a mesh and beside the balls placed so far, the larger the
/// better. It starts from random points inside and around the placed balls, and knows nothing of
/// the balls to come.
class RivalSearch {
 public:
  /// Draws the starting points: half of them anywhere inside, half of them near the surface.
  /// @param largest the radius of the largest ball, object units
  /// @pre the measure outlives this object
  RivalSearch(const MeshMeasure& measure, double largest, const RecheckOptions& options);

  /// The largest ball found beside the placed ones; radius 0 if there is none.
  Ball find();

  /// The largest ball found by climbing from a point inside; radius 0 or less if none fits there.
  Ball find_near(const Eigen::Vector3d& point);

  /// @pre the ball's centre is inside
  void place(const Ball& ball);

 private:
  /// A point inside the solid.
  struct Site {
    Eigen::Vector3d point;
    double radius = 0.0;           // of the ball that fits there, beside the placed ones
    double climbed_radius = -1.0;  // what the radius was when a climb began or ended here
  };

  Eigen::Vector3d random_direction();
  std::vector<Eigen::Vector3d> points_in_box(int count);
  std::vector<Eigen::Vector3d> points_near_surface(int count, double largest);
  double gap(const Eigen::Vector3d& point, double enough) const;
  Site measure(const Eigen::Vector3d& point) const;
  Site climb(Site site);

  const MeshMeasure& measure_;
  RecheckOptions options_;
  Random random_;
  std::vector<Ball> placed_;
  std::vector<Site> sites_;
};

}  // namespace mdbd
