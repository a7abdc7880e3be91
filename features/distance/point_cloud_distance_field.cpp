#include "features/distance/point_cloud_distance_field.h"

#include "features/core/errors.h"
#include "features/distance/enclosing_ball.h"

namespace mdbd {
namespace {

// Measured from a point near the cloud, for the sake of rounding.
Eigen::Vector3d mean_of(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) sum += point - origin;
  return origin + sum / static_cast<double>(points.size());
}

std::vector<Eigen::Vector3d> in_order_of(const PointTree& tree,
                                         const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<Eigen::Vector3d> ordered;
  for (const std::uint32_t source : tree.sources()) ordered.push_back(vectors[source]);
  return ordered;
}

}  // namespace

PointCloudDistanceField::PointCloudDistanceField(const OrientedCloud& cloud)
    : enclosing_ball_(mdbd::enclosing_ball(cloud.points)),
      centroid_(mean_of(cloud.points, enclosing_ball_.center)),
      tree_(cloud.points),
      winding_number_(tree_, in_order_of(tree_, cloud.area_vectors)) {
  if (!(enclosing_ball_.radius > 0)) throw InvalidInput("all points coincide");
}

void PointCloudDistanceField::measure(std::span<const DistanceQuery> queries,
                                      std::span<DistanceSample> samples) const {
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const DistanceQuery& query = queries[i];
    const Eigen::Vector3d& closest = tree_.points()[tree_.find_closest(query.point, query.bound)];
    const double distance = (closest - query.point).norm();
    const bool is_inside = query.side == Side::unknown ? winding_number_(query.point) > 0.5
                                                       : query.side == Side::inside;
    samples[i] = {is_inside ? distance : -distance, closest};
  }
}

}  // namespace mdbd
