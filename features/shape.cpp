#include "features/shape.h"

#include "features/core/errors.h"
#include "features/decomposition/decompose.h"
#include "features/distance/mesh_distance_field.h"
#include "features/shape_io/read_mesh.h"

namespace mdbd {

namespace {

Shape to_shape(const MeshFile& file) {
  // Where neighbours disagree on the outside, the sign changes away from the surface, too.
  const MeshStatistics& statistics = file.statistics;
  const bool is_closed = statistics.watertight && statistics.orientation != Orientation::mixed;
  return {.format = file.format,
          .representation = "mesh",
          .statistics = to_json(statistics),
          .field = std::make_unique<MeshDistanceField>(file.mesh, is_closed)};
}

}  // namespace

Shape load_shape(const std::filesystem::path& path) { return to_shape(read_mesh(path)); }

Shape make_mesh_shape(const TriangleMesh& mesh) { return to_shape(make_mesh(mesh)); }

BallDecomposition decompose_shape(const Shape& shape, const Recipe& recipe) {
  BallDecomposition decomposition =
      decompose(*shape.field, {.balls = recipe.balls,
                               .radius_tolerance = recipe.radius_tolerance,
                               .minimum_radius = recipe.minimum_radius});
  if (decomposition.balls.empty()) {
    throw InvalidInput("empty interior: the surface encloses no ball of the minimum radius");
  }
  return decomposition;
}

}  // namespace mdbd
