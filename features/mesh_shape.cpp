#include "features/mesh_shape.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "features/core/errors.h"
#include "features/denoise/denoise_mesh.h"
#include "features/distance/mesh_distance_field.h"
#include "features/shape_io/read_mesh.h"
#include "features/shape_unit.h"
#include "features/solidify/orient_shells.h"
#include "features/solidify/solidify_mesh.h"

namespace mdbd {
namespace {

/// A mesh that is ready to be measured, with what was done to it.
struct PreparedMesh {
  TriangleMesh mesh;
  bool is_closed = false;
  std::uint64_t faces_turned = 0;
  double noise = 0.0;
  double denoise_strength = 0.0;
  double enclosing_share = 1.0;
  double thickness = 0.0;  // of sheets that were solidified
};

// Where neighbours disagree on the outside, the sign changes away from the surface, too.
bool is_closed(const MeshStatistics& statistics) {
  return statistics.watertight && statistics.orientation != Orientation::mixed;
}

void orient(PreparedMesh& prepared, const MeshStatistics& statistics) {
  prepared.is_closed = is_closed(statistics);
  if (!statistics.watertight) return;
  if (prepared.is_closed && statistics.components == 1) return;
  prepared.faces_turned = orient_shells(prepared.mesh);
  // The statistics know of faces without area that the mesh no longer has.
  if (prepared.faces_turned == 0 && statistics.faces_degenerate == 0) return;
  prepared.is_closed = is_closed(measure_statistics(prepared.mesh));
}

void denoise(PreparedMesh& prepared, const Recipe& recipe) {
  if (recipe.denoise == "off") return;
  DenoisedMesh denoised = denoise_mesh(std::move(prepared.mesh));
  prepared.mesh = std::move(denoised.mesh);
  prepared.noise = denoised.noise;
  prepared.denoise_strength = denoised.strength;
}

void solidify(PreparedMesh& prepared, const Recipe& recipe) {
  if (recipe.solidify == "off") {
    prepared.enclosing_share =
        measure_enclosing_share(prepared.mesh, prepared.is_closed, recipe.minimum_radius);
    if (prepared.enclosing_share >= least_enclosing_share) return;
    throw InvalidInput(fmt::format(
        "the surface encloses nothing: only {:.0f} % of it has an inside (--solidify auto gives "
        "such sheets a thickness)",
        std::floor(100.0 * prepared.enclosing_share)));
  }
  SolidifiedMesh solid =
      solidify_mesh(std::move(prepared.mesh), prepared.is_closed, recipe.minimum_radius);
  prepared.mesh = std::move(solid.mesh);
  prepared.enclosing_share = solid.enclosing_share;
  prepared.thickness = solid.thickness;
  if (solid.thickness > 0) prepared.is_closed = is_closed(measure_statistics(prepared.mesh));
}

PreparedMesh prepare(TriangleMesh mesh, const MeshStatistics& statistics, const Recipe& recipe) {
  PreparedMesh prepared{.mesh = std::move(mesh)};
  orient(prepared, statistics);
  denoise(prepared, recipe);
  solidify(prepared, recipe);
  return prepared;
}

/// The record of a mesh with what was done to it.
std::string describe_preparation(const MeshFile& file, const PreparedMesh& prepared) {
  auto record = nlohmann::ordered_json::parse(to_json(file.statistics));
  record["unit"] = file.unit.empty() ? std::string(unknown_unit) : file.unit;
  record["faces_turned"] = prepared.faces_turned;
  record["noise"] = prepared.noise;
  record["denoise_filter"] = prepared.noise > 0.0 ? "umbrella" : "none";
  record["denoise_strength"] = prepared.denoise_strength;
  record["enclosing_share"] = prepared.enclosing_share;
  record["solidified"] = prepared.thickness > 0.0;
  record["sheet_thickness"] = prepared.thickness;
  return record.dump();
}

Shape to_shape(MeshFile file, const Recipe& recipe) {
  PreparedMesh prepared = prepare(std::move(file.mesh), file.statistics, recipe);
  return {.format = file.format,
          .representation = "mesh",
          .statistics = describe_preparation(file, prepared),
          .field = std::make_unique<MeshDistanceField>(prepared.mesh, prepared.is_closed),
          .surface = std::move(prepared.mesh)};
}

}  // namespace

Shape load_mesh_shape(const std::filesystem::path& path, const Recipe& recipe) {
  return to_shape(read_mesh(path), recipe);
}

Shape make_mesh_shape(const TriangleMesh& mesh, const Recipe& recipe) {
  return to_shape(make_mesh(mesh), recipe);
}

TriangleMesh prepare_surface(TriangleMesh mesh, const Recipe& recipe) {
  const MeshStatistics statistics = measure_statistics(mesh);
  return prepare(std::move(mesh), statistics, recipe).mesh;
}

}  // namespace mdbd
