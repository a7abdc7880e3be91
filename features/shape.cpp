#include "features/shape.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "features/core/errors.h"
#include "features/decomposition/decompose.h"
#include "features/denoise/denoise_mesh.h"
#include "features/distance/mesh_distance_field.h"
#include "features/shape_io/read_mesh.h"

namespace mdbd {

namespace {

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

}  // namespace

Shape load_shape(const std::filesystem::path& path, const Recipe& recipe) {
  return to_shape(read_mesh(path), recipe);
}

Shape make_mesh_shape(const TriangleMesh& mesh, const Recipe& recipe) {
  return to_shape(make_mesh(mesh), recipe);
}

TriangleMesh prepare_surface(TriangleMesh mesh, const Recipe& recipe) {
  return prepare(std::move(mesh), recipe).mesh;
}

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
