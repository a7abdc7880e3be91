#include "features/shape.h"

#include <algorithm>

#include "features/brep/solid_path.h"
#include "features/brep_shape.h"
#include "features/cloud_shape.h"
#include "features/core/errors.h"
#include "features/decomposition/decompose.h"
#include "features/implicit_shape.h"
#include "features/mesh_shape.h"
#include "features/modules/module.h"
#include "features/modules/readers.h"
#include "features/planar_shape.h"
#include "features/shape_io/read_mesh.h"
#include "features/shape_io/read_planar_domain.h"
#include "features/shape_io/read_point_cloud.h"
#include "features/shape_io/read_voxel_grid.h"
#include "features/shape_io/shape_files.h"
#include "features/voxel_shape.h"

namespace mdbd {
namespace {

constexpr std::string_view pcd_extensions[] = {".pcd"};

}  // namespace

Shape load_shape(const std::filesystem::path& path, const Recipe& recipe) {
  if (is_point_cloud_file(path)) return load_cloud_shape(path);
  if (is_brep_file(split_solid_path(path).file)) return load_brep_shape(path, recipe);
  if (has_extension(path, planar_file_extensions())) return load_planar_shape(path);
  if (has_extension(path, implicit_file_extensions())) return load_implicit_shape(path);
  if (has_extension(path, voxel_file_extensions())) return load_voxel_shape(path, recipe);
  return load_mesh_shape(path, recipe);
}

void preload_reader(const std::filesystem::path& path) {
  try {
    if (is_brep_file(split_solid_path(path).file)) load_module<CadModule>();
    if (has_extension(path, scene_file_extensions())) load_module<SceneModule>();
    if (has_extension(path, voxel_file_extensions())) load_module<VoxelModule>();
    if (has_extension(path, pcd_extensions)) load_module<PcdModule>();
  } catch (const IoError&) {
    return;
  }
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
