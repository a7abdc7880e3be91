#include "features/point_cloud/oriented_cloud.h"

#include <algorithm>
#include <string>

#include "features/core/errors.h"
#include "features/point_cloud/cloud_surface.h"
#include "features/point_cloud/neighbourhoods.h"
#include "features/point_cloud/orient_normals.h"
#include "features/point_cloud/outliers.h"

namespace mdbd {
namespace {

constexpr std::size_t neighbourhood_size = 12;
constexpr double least_agreement = 0.8;

/// The share of the points where two sets of normals point to the same side.
double agreement(const std::vector<Eigen::Vector3d>& left,
                 const std::vector<Eigen::Vector3d>& right) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < left.size(); ++i) count += left[i].dot(right[i]) > 0 ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(left.size());
}

/// Whether normals given point outward (1) or inward (-1); 0 if they are not consistent.
int sign_of_given(const PointCloud& cloud, const std::vector<Eigen::Vector3d>& outward) {
  const double share = agreement(cloud.normals, outward);
  if (share >= least_agreement) return 1;
  return share <= 1.0 - least_agreement ? -1 : 0;
}

PointCloud without(const PointCloud& cloud, const std::vector<bool>& is_dropped) {
  PointCloud kept;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (is_dropped[i]) continue;
    kept.points.push_back(cloud.points[i]);
    if (cloud.has_normals()) kept.normals.push_back(cloud.normals[i]);
  }
  return kept;
}

void require_enough(const PointCloud& cloud) {
  if (cloud.points.size() >= fewest_points) return;
  throw InvalidInput("too few points: " + std::to_string(cloud.points.size()) +
                     " different ones, at least " + std::to_string(fewest_points) + " are needed");
}

OrientedCloud orient(const PointCloud& cloud, const Neighbourhoods& neighbourhoods) {
  const CloudSurface surface = estimate_surface(cloud, neighbourhoods);
  std::vector<Eigen::Vector3d> normals = orient_normals(cloud, surface, neighbourhoods);
  OrientedCloud oriented{.points = cloud.points,
                         .area_vectors = {},
                         .spacing = surface.spacing,
                         .orientation = "flood from outside"};
  double sign = 1.0;
  const int given = cloud.has_normals() ? sign_of_given(cloud, normals) : 0;
  if (given != 0) {
    sign = given;
    normals = cloud.normals;
    oriented.orientation = given > 0 ? "given normals" : "given normals, turned";
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    oriented.area_vectors.push_back(sign * surface.areas[i] * normals[i]);
  }
  return oriented;
}

}  // namespace

OrientedCloud orient_cloud(const PointCloud& cloud) {
  require_enough(cloud);
  const Neighbourhoods neighbourhoods(cloud.points, neighbourhood_size);
  const std::vector<bool> is_outlier = find_outliers(cloud, neighbourhoods);
  const auto outliers = static_cast<std::size_t>(std::ranges::count(is_outlier, true));
  if (outliers == 0) return orient(cloud, neighbourhoods);
  const PointCloud kept = without(cloud, is_outlier);
  OrientedCloud oriented = orient(kept, Neighbourhoods(kept.points, neighbourhood_size));
  oriented.outliers = outliers;
  return oriented;
}

}  // namespace mdbd
