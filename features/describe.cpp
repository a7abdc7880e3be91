#include "features/describe.h"

#include "features/core/errors.h"
#include "features/decomposition/decompose.h"
#include "features/descriptor/compute_descriptor.h"
#include "features/distance/mesh_distance_field.h"
#include "features/shape_io/read_mesh.h"

namespace mdbd {

ShapeDescription describe_file(const std::filesystem::path& path, const Recipe& recipe) {
  const MeshFile file = read_mesh(path);
  const MeshDistanceField field(file.mesh);
  const DecompositionOptions options{.balls = recipe.balls,
                                     .radius_tolerance = recipe.radius_tolerance,
                                     .minimum_radius = recipe.minimum_radius};
  ShapeDescription description{.format = file.format,
                               .representation = "mesh",
                               .statistics = to_json(file.statistics),
                               .decomposition = decompose(field, options),
                               .descriptor = {}};
  if (description.decomposition.balls.empty()) {
    throw InvalidInput("empty interior: the surface encloses no ball of the minimum radius");
  }
  description.descriptor = compute_descriptor(description.decomposition, recipe);
  return description;
}

}  // namespace mdbd
