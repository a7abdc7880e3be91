#include "bench/rival/voxel_grid.h"

#include <catch2/catch.hpp>

#include "bench/generated_shapes.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;

namespace {

void check_voxels(const TriangleMesh& mesh, int resolution) {
  const bench::VoxelGrid grid = bench::make_voxel_grid(mesh, resolution);
  const std::vector<std::uint8_t> is_inside = bench::voxelise(mesh, grid);
  REQUIRE(is_inside.size() == grid.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < is_inside.size(); ++i) {
    const bool is_expected = test::mesh_winding(mesh, grid.center(i)) > 0.5;
    if ((is_inside[i] != 0) != is_expected) ++wrong;
  }
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("voxels are inside where the winding number says so") {
  SECTION("faces along the axes") { check_voxels(test::make_cube(), 16); }
  SECTION("a smooth shape") { check_voxels(bench::make_ring(400), 30); }
  SECTION("thin walls") { check_voxels(bench::make_bracket(), 40); }
  SECTION("overlapping parts") {
    TriangleMesh mesh = test::make_cube();
    const TriangleMesh other = bench::make_ring(400);
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles) {
      mesh.triangles.push_back({a + offset, b + offset, c + offset});
    }
    check_voxels(mesh, 24);
  }
}

TEST_CASE("rows through edges and corners cross a surface once") {
  const TriangleMesh mesh = test::make_cube();
  const bench::VoxelGrid grid{
      .origin = {-0.5, -0.5, -0.5}, .voxel_size = 0.25, .counts = {9, 9, 9}};
  const std::vector<std::uint8_t> is_inside = bench::voxelise(mesh, grid);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < is_inside.size(); ++i) {
    const Eigen::Array3d center = grid.center(i);
    const bool is_within = (center > 0.0).all() && (center < 1.0).all();
    const bool is_beyond = (center < 0.0).any() || (center > 1.0).any();
    if ((is_within && is_inside[i] == 0) || (is_beyond && is_inside[i] != 0)) ++wrong;
  }
  CHECK(wrong == 0);
}
