#include "features/denoise/vertex_neighbours.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/perturbation/meshes.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;

namespace {

std::vector<std::uint32_t> list(const VertexNeighbours& neighbours, std::uint32_t vertex) {
  const auto ring = neighbours.of(vertex);
  return {ring.begin(), ring.end()};
}

std::size_t open_ends(const VertexNeighbours& neighbours) {
  return static_cast<std::size_t>(std::ranges::count(neighbours.is_open, char{1}));
}

}  // namespace

TEST_CASE("the neighbours of the corners of a cube") {
  const VertexNeighbours neighbours = find_neighbours(test::make_cube());
  REQUIRE(neighbours.size() == 8);
  CHECK(list(neighbours, 0) == std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6});
  CHECK(list(neighbours, 7) == std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6});
  CHECK(list(neighbours, 2) == std::vector<std::uint32_t>{0, 3, 6, 7});
  CHECK(neighbours.vertices.size() == 36);
  CHECK(open_ends(neighbours) == 0);
}

TEST_CASE("the border of a sheet is open") {
  const VertexNeighbours neighbours = find_neighbours(test::make_sheet(5));
  CHECK(open_ends(neighbours) == 40);
}

TEST_CASE("edges of three faces and vertices without faces are no obstacle") {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const VertexNeighbours neighbours = find_neighbours(mesh);
  CHECK(list(neighbours, 0) == std::vector<std::uint32_t>{1, 2, 3, 4});
  CHECK(neighbours.openness_of(0)[0] == 0);
  CHECK(neighbours.openness_of(0)[1] == 1);
  CHECK(neighbours.of(5).empty());
  CHECK(find_neighbours({}).size() == 0);
}
