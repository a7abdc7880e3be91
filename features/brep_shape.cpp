#include "features/brep_shape.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "features/brep/brep_distance_field.h"
#include "features/brep/read_brep.h"
#include "features/mesh_shape.h"
#include "features/solidify/solidify_mesh.h"

namespace mdbd {
namespace {

using Json = nlohmann::ordered_json;

Json describe(const BrepFile& file) {
  return {{"unit", "mm"},
          {"file_unit", file.file_unit},
          {"solids", file.solids},
          {"faces", file.faces},
          {"faces_ignored", file.faces_ignored},
          {"solids_turned", file.solids_turned},
          {"sewn", file.is_sewn},
          {"closed", file.brep.is_closed}};
}

// Open faces as a mesh, with what the way of meshes says of it.
Shape make_sheet(const BrepFile& file, const Recipe& recipe, const char* why) {
  Shape shape = make_mesh_shape(file.brep.mesh, recipe);
  Json record = Json::parse(shape.statistics);
  record.update(describe(file));
  record["tessellated"] = why;
  shape.format = file.format;
  shape.statistics = record.dump();
  return shape;
}

}  // namespace

Shape load_brep_shape(const std::filesystem::path& path, const Recipe& recipe) {
  BrepFile file = read_brep(path);
  if (file.solids == 0) return make_sheet(file, recipe, "no solid: measured as a mesh");
  const double share =
      measure_enclosing_share(file.brep.mesh, file.brep.is_closed, recipe.minimum_radius);
  if (share < least_enclosing_share) {
    return make_sheet(file, recipe, "encloses nothing of the minimum radius: measured as a mesh");
  }
  Json record = describe(file);
  auto field = std::make_unique<BrepDistanceField>(std::move(file.brep));
  record["inside"] = "winding number";
  record["deflection"] = field->deflection();
  return {.format = file.format,
          .representation = "B-rep",
          .statistics = record.dump(),
          .field = std::move(field)};
}

}  // namespace mdbd
