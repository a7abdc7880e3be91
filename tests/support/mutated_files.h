#pragma once

#include <algorithm>
#include <bit>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/cloud_writers.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/scene_writers.h"
#include "tests/support/voxel_writers.h"

/// Files as accidents and attackers leave them. Everything depends on the seed alone.
namespace mdbd::test {

using FilesOfReader = std::pair<std::string, std::vector<std::string>>;

/// Small shapes as files of each kind that a reader knows, by reader: ending and contents.
inline std::vector<FilesOfReader> sound_meshes() {
  const TriangleMesh mesh = make_torus(2.0, 0.5, 5, 3);
  return {{".off", {to_off(mesh)}},
          {".obj", {to_obj(mesh)}},
          {".ply",
           {to_ply_text(mesh), to_ply_binary<float>(mesh, std::endian::little),
            to_ply_binary<double>(mesh, std::endian::big)}},
          {".stl", {to_stl_text(mesh), to_stl_binary(mesh)}}};
}

inline std::vector<FilesOfReader> sound_clouds() {
  PointCloud bare;
  bare.points = make_sphere(1.0, 6).vertices;
  PointCloud cloud = bare;
  cloud.normals = bare.points;
  return {{".pcd",
           {to_pcd(cloud, PcdEncoding::text), to_pcd(cloud, PcdEncoding::binary),
            to_pcd(bare, PcdEncoding::compressed)}},
          {".xyz", {to_table(cloud, " "), to_table(bare, " ")}},
          {".csv", {to_table(cloud, ","), to_table(bare, ", ")}},
          {".ply", {to_ply(cloud), to_ply(bare)}}};
}

inline std::vector<FilesOfReader> sound_scenes() {
  std::vector<FilesOfReader> files;
  for (const auto& [ending, content] : scene_files({.mesh = make_torus(2.0, 0.5, 5, 3)})) {
    files.push_back({ending, {content}});
  }
  return files;
}

inline std::vector<FilesOfReader> sound_drawings() {
  return {
      {".svg", {R"svg(<svg xmlns="http://www.w3.org/2000/svg"><g transform="scale(2) rotate(30)">
              <circle r="3"/><path d="M0 0h4v3q1 2 2 0t2 0c1 1 2 2 3 3a3 2 30 0 1 1 1z"/>
              <rect x="1mm" width="4" height="2" rx="1"/></g></svg>)svg"}},
      {".wkt",
       {"POLYGON((0 0,4 0,4 3,0 3,0 0),(1 1,2 1,2 2,1 2,1 1))",
        "MULTIPOLYGON(((0 0,4 0,4 3)),((10 0,11 0,11 1,10 1)))"}}};
}

inline std::vector<FilesOfReader> sound_solids() {
  const std::string block =
      R"({"format": "mdbd-csg", "solid": {"difference": [
          {"box": {"min": [-2, -1, -1], "max": [2, 1, 1]}},
          {"cylinder": {"from": [0, 0, -2], "to": [0, 0, 2], "radius": 0.5}}]}})";
  const std::string ring =
      R"({"format": "mdbd-csg", "solid": {"translate": [1, 2, 3], "of": {"rotate":
          {"axis": [1, 0, 0], "degrees": 30}, "of": {"union": [{"sphere": {"radius": 1}},
          {"torus": {"radius": 2, "tube_radius": 0.5}}, {"intersection": [
          {"scale": 2, "of": {"sphere": {"radius": 1}}},
          {"halfspace": {"point": [0, 0, 1], "outward": [0, 0, 1]}}]}]}}}})";
  const VoxelGrid grid = sample_grid(7, 1.3, ball_distance_at);
  return {{".json", {block, ring}},
          {".nrrd", {to_nrrd_text(grid), to_nrrd_raw(grid)}},
          {".mha", {to_metaimage(grid)}},
          {".vtk", {to_vtk(grid, true), to_vtk(grid, false)}},
          {".vti", {to_vti(grid)}}};
}

/// Changes the content of files.
class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : random_(seed) {}

  /// One to three changes, each of a random kind.
  std::string mutate(std::string content) {
    for (std::size_t i = 0, changes = 1 + below(3); i < changes; ++i) {
      switch (below(4)) {
        case 0:
          flip(content);
          break;
        case 1:
          content.resize(below(content.size() + 1));
          break;
        case 2:
          repeat(content);
          break;
        default:
          inflate(content);
      }
    }
    return content;
  }

 private:
  static constexpr std::size_t header_size = 200;

  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  // Half of the places are where headers are.
  std::size_t place(const std::string& content) {
    return below(below(2) == 0 ? content.size() : std::min(content.size(), header_size));
  }

  void flip(std::string& content) {
    for (std::size_t i = 0, bytes = 1 + below(8); i < bytes && !content.empty(); ++i) {
      content[place(content)] = static_cast<char>(random_());
    }
  }

  void repeat(std::string& content) {
    const std::size_t start = place(content);
    const std::string part = content.substr(start, 1 + below(content.size()));
    for (std::size_t i = 0, times = 1 + below(20); i < times; ++i) content.insert(start, part);
  }

  // A number in a text becomes a huge one, or four bytes become a huge count.
  void inflate(std::string& content) {
    const std::size_t at = content.find_first_of("0123456789", place(content));
    if (at != content.npos && below(2) == 0) {
      const std::size_t end = std::min(content.find_first_not_of("0123456789", at), content.size());
      constexpr const char* huge[] = {"4294967295", "2147483648", "99999999", "-1", "1e308"};
      content.replace(at, end - at, huge[below(std::size(huge))]);
    } else if (content.size() >= 4) {
      const std::size_t start = std::min(place(content), content.size() - 4);
      content.replace(start, 4, below(2) == 0 ? "\xff\xff\xff\x7f" : "\xff\xff\xff\xff");
    }
  }

  std::mt19937 random_;
};

}  // namespace mdbd::test
