#include "features/voxel_shape.h"

#include <nlohmann/json.hpp>

#include "features/mesh_shape.h"
#include "features/shape_io/read_voxel_grid.h"
#include "features/voxel/iso_surface.h"

namespace mdbd {
namespace {

// Smaller balls are in the facets of the surface, not in the solid.
constexpr double least_radius_in_steps = 0.5;

/// The record of a grid, with that of the mesh it became.
std::string describe_grid(const VoxelGrid& grid, const IsoSurface& surface,
                          const std::string& mesh_record) {
  const Eigen::Vector3d spacing = grid.steps.colwise().norm();
  nlohmann::ordered_json record = {{"grid", grid.size},
                                   {"spacing", {spacing.x(), spacing.y(), spacing.z()}},
                                   {"values", surface.kind},
                                   {"iso_value", surface.value},
                                   {"inside", surface.inside + " the iso value"}};
  record.update(nlohmann::ordered_json::parse(mesh_record));
  return record.dump();
}

}  // namespace

Shape load_voxel_shape(const std::filesystem::path& path, const Recipe& recipe) {
  const VoxelFile file = read_voxel_grid(path);
  Shape shape = make_voxel_shape(file.grid, recipe);
  shape.format = file.format;
  return shape;
}

Shape make_voxel_shape(const VoxelGrid& grid, const Recipe& recipe) {
  const IsoSurface surface = find_iso_surface(grid);
  Shape shape = make_mesh_shape(surface.mesh, recipe);
  shape.representation = "voxel grid";
  shape.least_radius = least_radius_in_steps * grid.steps.colwise().norm().minCoeff();
  shape.statistics = describe_grid(grid, surface, shape.statistics);
  return shape;
}

}  // namespace mdbd
