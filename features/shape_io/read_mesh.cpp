#include "features/shape_io/read_mesh.h"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/Geometry>

#include "features/core/errors.h"
#include "features/shape_io/assimp_reader.h"
#include "features/shape_io/clean_mesh.h"
#include "features/shape_io/input_file.h"
#include "features/shape_io/openmesh_reader.h"
#include "features/shape_io/plain_file.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

using MakePlain = PlainFile (*)(std::string_view bytes);

// In the order of the functions below, then those that are assimp's.
constexpr std::array<std::string_view, 9> extensions = {".off", ".obj", ".ply", ".stl", ".3mf",
                                                        ".3ds", ".dae", ".glb", ".gltf"};
constexpr std::array<MakePlain, 4> make_plain = {plain_off, plain_obj, plain_ply, plain_stl};

constexpr double smallest_extent = 1e-90;  // its cube fits double precision

std::size_t format_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  const auto* found = std::ranges::find_if(
      extensions, [&](std::string_view known) { return equals_ignoring_case(known, extension); });
  return static_cast<std::size_t>(found - extensions.begin());
}

SceneMesh read_polygons(const std::filesystem::path& path, std::size_t format) {
  const std::string bytes = read_input_file(path);
  if (bytes.find_first_not_of(" \t\r\n\v\f") == bytes.npos) {
    throw InvalidInput("the file is empty but for blanks");
  }
  if (format >= make_plain.size()) return read_with_assimp(path, extensions[format], bytes);
  return {.polygons = read_with_openmesh(make_plain[format](bytes)), .unit = ""};
}

void require_usable_extent(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  if (box.sizes().maxCoeff() >= smallest_extent) return;
  throw InvalidInput("the model is smaller than 1e-90 units; scale it up");
}

MeshFile clean(const PolygonMesh& polygons) {
  CleanedMesh cleaned = clean_mesh(polygons);
  require_usable_extent(cleaned.mesh);
  MeshFile file;
  file.statistics = cleaned.statistics;
  file.mesh = std::move(cleaned.mesh);
  if (file.statistics.orientation == Orientation::inverted) {
    for (Triangle& triangle : file.mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return file;
}

}  // namespace

std::span<const std::string_view> mesh_file_extensions() { return extensions; }

std::span<const std::string_view> scene_file_extensions() {
  return std::span(extensions).subspan(make_plain.size());
}

bool has_mesh_extension(const std::filesystem::path& path) {
  return format_of(path) < extensions.size();
}

MeshFile read_mesh(const std::filesystem::path& path) {
  const std::size_t format = format_of(path);
  if (format == extensions.size()) {
    throw InvalidInput(
        "the name does not end in .off, .obj, .ply, .stl, .3mf, .3ds, .dae, .glb or .gltf");
  }
  SceneMesh scene = read_polygons(path, format);
  MeshFile file = clean(scene.polygons);
  file.format = extensions[format].substr(1);
  file.unit = std::move(scene.unit);
  return file;
}

MeshFile make_mesh(const TriangleMesh& mesh) {
  PolygonMesh polygons;
  polygons.vertices = mesh.vertices;
  polygons.file_vertices = mesh.vertices.size();
  polygons.file_faces = mesh.triangles.size();
  for (const Triangle& triangle : mesh.triangles) {
    polygons.corners.insert(polygons.corners.end(), triangle.begin(), triangle.end());
    polygons.face_ends.push_back(polygons.corners.size());
  }
  return clean(polygons);
}

}  // namespace mdbd
