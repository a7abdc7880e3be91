#include "features/brep_shape.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "features/brep/brep_distance_field.h"
#include "features/brep/read_brep.h"
#include "features/brep/solid_path.h"
#include "features/mesh_shape.h"
#include "features/solidify/solidify_mesh.h"

namespace mdbd {
namespace {

using Json = nlohmann::ordered_json;

Json describe(const BrepFile& file, std::size_t solid) {
  Json record = {{"unit", "mm"},
                 {"file_unit", file.file_unit},
                 {"solids", file.solids},
                 {"faces", file.faces},
                 {"faces_ignored", file.faces_ignored},
                 {"solids_turned", file.solids_turned},
                 {"sewn", file.is_sewn},
                 {"closed", file.brep.is_closed}};
  if (solid > 0) record["solid"] = solid;
  return record;
}

// Open faces as a mesh, with what the way of meshes says of it.
Shape make_sheet(const BrepFile& file, const Json& description, const Recipe& recipe,
                 const char* why) {
  Shape shape = make_mesh_shape(file.brep.mesh, recipe);
  Json record = Json::parse(shape.statistics);
  record.update(description);
  record["tessellated"] = why;
  shape.format = file.format;
  shape.statistics = record.dump();
  return shape;
}

}  // namespace

Shape load_brep_shape(const std::filesystem::path& path, const Recipe& recipe) {
  const SolidPath wanted = split_solid_path(path);
  BrepFile file = read_brep(wanted.file, wanted.solid);
  Json record = describe(file, wanted.solid);
  if (file.solids == 0) return make_sheet(file, record, recipe, "no solid: measured as a mesh");
  const double share =
      measure_enclosing_share(file.brep.mesh, file.brep.is_closed, recipe.minimum_radius);
  if (share < least_enclosing_share) {
    return make_sheet(file, record, recipe,
                      "encloses nothing of the minimum radius: measured as a mesh");
  }
  TriangleMesh surface = file.brep.mesh;
  auto field = std::make_unique<BrepDistanceField>(std::move(file.brep));
  record["inside"] = "winding number";
  record["deflection"] = field->deflection();
  return {.format = file.format,
          .representation = "B-rep",
          .statistics = record.dump(),
          .field = std::move(field),
          .surface = std::move(surface)};
}

}  // namespace mdbd
