#include "features/shape.h"

#include <algorithm>

#include "features/brep/read_brep.h"
#include "features/brep_shape.h"
#include "features/cloud_shape.h"
#include "features/core/errors.h"
#include "features/decomposition/decompose.h"
#include "features/mesh_shape.h"
#include "features/shape_io/read_point_cloud.h"

namespace mdbd {

Shape load_shape(const std::filesystem::path& path, const Recipe& recipe) {
  if (is_point_cloud_file(path)) return load_cloud_shape(path);
  if (is_brep_file(path)) return load_brep_shape(path, recipe);
  return load_mesh_shape(path, recipe);
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
