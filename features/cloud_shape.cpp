#include "features/cloud_shape.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "features/distance/point_cloud_distance_field.h"
#include "features/point_cloud/oriented_cloud.h"
#include "features/shape_io/read_point_cloud.h"
#include "features/shape_unit.h"

namespace mdbd {
namespace {

// A ball of less than that may lie on the boundary between samples, and not inside.
constexpr double least_radius_in_spacings = 1.0;

/// The record of a cloud with what was made of it.
std::string describe_cloud(const PointCloudFile& file, const OrientedCloud& oriented) {
  const nlohmann::ordered_json record = {
      {"points", oriented.points.size()},
      {"unit", unknown_unit},
      {"points_not_finite", file.points_not_finite},
      {"points_duplicate", file.points_duplicate},
      {"points_outlier", oriented.outliers},
      {"normals_given", file.cloud.has_normals()},
      {"inside", "winding number"},
      {"orientation", oriented.orientation},
      {"spacing", oriented.spacing},
      {"least_radius", least_radius_in_spacings * oriented.spacing}};
  return record.dump();
}

PointCloud visible_points(OrientedCloud oriented) {
  for (Eigen::Vector3d& normal : oriented.area_vectors) normal.normalize();
  return {.points = std::move(oriented.points), .normals = std::move(oriented.area_vectors)};
}

Shape to_shape(const PointCloudFile& file) {
  OrientedCloud oriented = orient_cloud(file.cloud);
  return {.format = file.format,
          .representation = "point cloud",
          .statistics = describe_cloud(file, oriented),
          .field = std::make_unique<PointCloudDistanceField>(oriented),
          .least_radius = least_radius_in_spacings * oriented.spacing,
          .surface = visible_points(std::move(oriented))};
}

}  // namespace

Shape load_cloud_shape(const std::filesystem::path& path) {
  return to_shape(read_point_cloud(path));
}

Shape make_cloud_shape(const PointCloud& cloud) { return to_shape(clean_point_cloud(cloud)); }

}  // namespace mdbd
