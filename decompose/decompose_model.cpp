#include "decompose/decompose_model.h"

#include <variant>

#include <fmt/format.h>

#include "features/core/errors.h"
#include "features/shape.h"

namespace mdbd {
namespace {

PlanarDomain outlines_of(const Shape& shape) {
  const auto* outlines = std::get_if<PlanarDomain>(&shape.surface);
  return outlines == nullptr ? PlanarDomain{} : *outlines;
}

DecomposedModel decompose_file(const std::filesystem::path& path, const Recipe& recipe) {
  const Shape shape = load_shape(path, recipe);
  BallDecomposition decomposition = decompose_shape(shape, recipe);
  ContactGraph contacts = build_contact_graph(decomposition.balls, recipe.contact_tolerance);
  const Certificate certificate = check_certificate(*shape.field, decomposition);
  return {.path = path.string(),
          .representation = shape.representation,
          .statistics = shape.statistics,
          .outlines = outlines_of(shape),
          .recipe = recipe,
          .minimum_radius = minimum_radius(shape, recipe),
          .decomposition = std::move(decomposition),
          .contacts = std::move(contacts),
          .certificate = certificate};
}

}  // namespace

DecomposedModel decompose_model(const std::filesystem::path& path, const Recipe& recipe) {
  try {
    return decompose_file(path, recipe);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", path.string(), error.what()));
  } catch (const IoError& error) {
    throw IoError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

std::string explain_shortage(const DecomposedModel& model) {
  if (model.decomposition.termination == Termination::ball_count) return {};
  const bool is_own = model.minimum_radius > model.recipe.minimum_radius;
  return fmt::format(
      "{} of {} balls: every further ball is smaller than the minimum radius, {:.4g} of the "
      "enclosing ball's{}",
      model.decomposition.balls.size(), model.recipe.balls, model.minimum_radius,
      is_own ? ", the spacing of the points" : "");
}

}  // namespace mdbd
