// write_shape_files FOLDER: writes a file for each module of readers.
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/brep/occt_solids.h"
#include "tests/support/cloud_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/scene_writers.h"
#include "tests/support/voxel_writers.h"

namespace {

void write(const std::filesystem::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  using namespace mdbd::test;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  OcctSolid::box({0, 0, 0}, {1, 2, 3}).write_step(folder / "box.step");
  write(folder / "cube.3mf", to_3mf({.mesh = make_cube()}));
  write(folder / "ball.vti", to_vti(sample_grid(9, 1.5, ball_distance_at)));
  write(folder / "sphere.pcd",
        to_pcd({.points = make_sphere(1, 16).vertices, .normals = {}}, PcdEncoding::binary));
}
