#include "features/shape.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "features/core/errors.h"
#include "features/decomposition/decompose.h"
#include "features/denoise/denoise_mesh.h"
#include "features/distance/mesh_distance_field.h"
#include "features/distance/point_cloud_distance_field.h"
#include "features/point_cloud/oriented_cloud.h"
#include "features/shape_io/read_mesh.h"
#include "features/shape_io/read_point_cloud.h"

namespace mdbd {

namespace {

// A ball of less than that may lie on the boundary between samples, and not inside.
constexpr double least_radius_in_spacings = 1.0;

/// The record of a mesh with what was done to it.
std::string describe_preparation(const MeshStatistics& statistics, const DenoisedMesh& denoised) {
  auto record = nlohmann::ordered_json::parse(to_json(statistics));
  record["noise"] = denoised.noise;
  record["denoise_filter"] = denoised.noise > 0.0 ? "umbrella" : "none";
  record["denoise_strength"] = denoised.strength;
  return record.dump();
}

DenoisedMesh prepare(TriangleMesh mesh, const Recipe& recipe) {
  if (recipe.denoise == "off") return {.mesh = std::move(mesh)};
  return denoise_mesh(std::move(mesh));
}

Shape to_shape(MeshFile file, const Recipe& recipe) {
  // Where neighbours disagree on the outside, the sign changes away from the surface, too.
  const MeshStatistics& statistics = file.statistics;
  const bool is_closed = statistics.watertight && statistics.orientation != Orientation::mixed;
  const DenoisedMesh denoised = prepare(std::move(file.mesh), recipe);
  return {.format = file.format,
          .representation = "mesh",
          .statistics = describe_preparation(statistics, denoised),
          .field = std::make_unique<MeshDistanceField>(denoised.mesh, is_closed)};
}

/// The record of a cloud with what was made of it.
std::string describe_cloud(const PointCloudFile& file, const OrientedCloud& oriented) {
  const nlohmann::ordered_json record = {
      {"points", oriented.points.size()},
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

Shape to_shape(const PointCloudFile& file) {
  const OrientedCloud oriented = orient_cloud(file.cloud);
  return {.format = file.format,
          .representation = "point cloud",
          .statistics = describe_cloud(file, oriented),
          .field = std::make_unique<PointCloudDistanceField>(oriented),
          .least_radius = least_radius_in_spacings * oriented.spacing};
}

}  // namespace

Shape load_shape(const std::filesystem::path& path, const Recipe& recipe) {
  if (is_point_cloud_file(path)) return to_shape(read_point_cloud(path));
  return to_shape(read_mesh(path), recipe);
}

Shape make_mesh_shape(const TriangleMesh& mesh, const Recipe& recipe) {
  return to_shape(make_mesh(mesh), recipe);
}

Shape make_cloud_shape(const PointCloud& cloud) { return to_shape(clean_point_cloud(cloud)); }

TriangleMesh prepare_surface(TriangleMesh mesh, const Recipe& recipe) {
  return prepare(std::move(mesh), recipe).mesh;
}

double minimum_radius(const Shape& shape, const Recipe& recipe) {
  return std::max(recipe.minimum_radius, shape.least_radius / shape.field->enclosing_ball().radius);
}

BallDecomposition decompose_shape(const Shape& shape, const Recipe& recipe) {
  BallDecomposition decomposition =
      decompose(*shape.field, {.balls = recipe.balls,
                               .radius_tolerance = recipe.radius_tolerance,
                               .minimum_radius = minimum_radius(shape, recipe)});
  if (decomposition.balls.empty()) {
    throw InvalidInput("empty interior: the surface encloses no ball of the minimum radius");
  }
  return decomposition;
}

}  // namespace mdbd
