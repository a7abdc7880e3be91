#include "evaluation/reports/certificate_checks.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "features/core/errors.h"
#include "features/core/random.h"
#include "features/mesh_shape.h"
#include "features/shape.h"
#include "features/shape_io/read_mesh.h"

using nlohmann::ordered_json;

namespace mdbd {

// Found by nlohmann_json, which wants these names.
void to_json(ordered_json& json, const Violation& violation) {
  json = {violation.size, violation.ball};
}

void from_json(const ordered_json& json, Violation& violation) {
  json.at(0).get_to(violation.size);
  json.at(1).get_to(violation.ball);
}

namespace {

CheckedModel check_model(const LabelledModel& model, const DescribedModel& description,
                         const Recipe& recipe, const RecheckOptions& options) {
  MeshFile file = read_mesh(model.file.path);
  const bool is_complete = description.balls.size() >= static_cast<std::size_t>(recipe.balls);
  CheckedModel checked{
      .model = model,
      .triangles = file.mesh.triangles.size(),
      .balls = description.balls.size(),
      .is_closed = file.statistics.watertight && file.statistics.orientation != Orientation::mixed,
      .result = {}};
  const TriangleMesh surface = prepare_surface(std::move(file.mesh), recipe);
  checked.result = recheck_balls(surface, description.balls, description.scale,
                                 is_complete ? 0.0 : recipe.minimum_radius, options);
  return checked;
}

/// What a process sends of a checked model.
std::string pack(const CheckedModel& checked) {
  const ordered_json json = {checked.triangles,     checked.is_closed,
                             checked.result.escape, checked.result.overlap,
                             checked.result.excess, checked.result.search_reach};
  const std::vector<std::uint8_t> bytes = ordered_json::to_cbor(json);
  return {bytes.begin(), bytes.end()};
}

CheckedModel unpack(const LabelledModel& model, std::size_t balls, const std::string& bytes) {
  const ordered_json json = ordered_json::from_cbor(bytes);
  CheckedModel checked{.model = model, .balls = balls, .result = {}};
  json.at(0).get_to(checked.triangles);
  json.at(1).get_to(checked.is_closed);
  json.at(2).get_to(checked.result.escape);
  json.at(3).get_to(checked.result.overlap);
  json.at(4).get_to(checked.result.excess);
  json.at(5).get_to(checked.result.search_reach);
  return checked;
}

}  // namespace

std::vector<CheckedModel> check_models(const EvaluationInput& input,
                                       const RecheckOptions& options) {
  const CleanModels clean = describe_clean_models(input);
  std::vector<std::string> names;
  for (const LabelledModel& model : clean.models) names.push_back(model.name);
  const auto results = input.cache.run("re-checks", names, [&](std::size_t i) {
    RecheckOptions own = options;
    own.seed = derive_seed(input.seed, names[i]);
    return pack(check_model(clean.models[i], clean.descriptions[i], input.cache.recipe(), own));
  });
  std::vector<CheckedModel> checked;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!results[i]) continue;
    checked.push_back(unpack(clean.models[i], clean.descriptions[i].balls.size(), *results[i]));
  }
  if (checked.empty()) {
    throw InvalidInput(fmt::format("none of the {} models could be re-checked; the last: {}",
                                   names.size(), input.cache.failures().back().reason));
  }
  return checked;
}

}  // namespace mdbd
