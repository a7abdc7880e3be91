#include "decompose/decompose_model.h"

#include <fmt/format.h>

#include "features/core/errors.h"
#include "features/decomposition/decompose.h"
#include "features/distance/mesh_distance_field.h"
#include "features/shape_io/read_mesh.h"

namespace mdbd {
namespace {

DecomposedModel decompose_mesh(const std::filesystem::path& path, const Recipe& recipe) {
  const MeshFile file = read_mesh(path);
  const MeshDistanceField field(file.mesh);
  BallDecomposition decomposition = decompose(field, {.balls = recipe.balls,
                                                      .radius_tolerance = recipe.radius_tolerance,
                                                      .minimum_radius = recipe.minimum_radius});
  if (decomposition.balls.empty()) {
    throw InvalidInput("empty interior: the surface encloses no ball of the minimum radius");
  }
  ContactGraph contacts = build_contact_graph(decomposition.balls, recipe.contact_tolerance);
  const Certificate certificate = check_certificate(field, decomposition);
  return {.path = path.string(),
          .representation = "mesh",
          .statistics = to_json(file.statistics),
          .recipe = recipe,
          .decomposition = std::move(decomposition),
          .contacts = std::move(contacts),
          .certificate = certificate};
}

}  // namespace

DecomposedModel decompose_model(const std::filesystem::path& path, const Recipe& recipe) {
  try {
    return decompose_mesh(path, recipe);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", path.string(), error.what()));
  } catch (const IoError& error) {
    throw IoError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

std::string explain_shortage(const DecomposedModel& model) {
  if (model.decomposition.termination == Termination::ball_count) return {};
  return fmt::format(
      "{} of {} balls: every further ball is smaller than the minimum radius, {} of the enclosing "
      "ball's",
      model.decomposition.balls.size(), model.recipe.balls, model.recipe.minimum_radius);
}

}  // namespace mdbd
