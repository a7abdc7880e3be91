#include "features/shape_io/mesh_statistics.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/sample_meshes.h"

namespace mdbd::test {
namespace {

void append(TriangleMesh& mesh, const TriangleMesh& other, double scale,
            const Eigen::Vector3d& shift, bool is_inverted = false) {
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : other.vertices) {
    mesh.vertices.emplace_back(scale * vertex + shift);
  }
  for (auto [a, b, c] : other.triangles) {
    if (is_inverted) std::swap(b, c);
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
  }
}

}  // namespace

TEST_CASE("Statistics of a closed mesh") {
  const MeshStatistics statistics = measure_statistics(make_torus(3, 1, 10, 8));
  CHECK(statistics.vertices == 80);
  CHECK(statistics.faces == 160);
  CHECK(statistics.watertight);
  CHECK(statistics.open_edges == 0);
  CHECK(statistics.non_manifold_edges == 0);
  CHECK(statistics.components == 1);
  CHECK(statistics.orientation == Orientation::outward);
}

TEST_CASE("A missing face opens its edges") {
  TriangleMesh mesh = make_cube();
  mesh.triangles.pop_back();
  const MeshStatistics statistics = measure_statistics(mesh);
  CHECK_FALSE(statistics.watertight);
  CHECK(statistics.open_edges == 3);
  CHECK(statistics.orientation == Orientation::outward);
}

TEST_CASE("Two cubes that share an edge are watertight but not manifold") {
  TriangleMesh mesh = make_cube();
  append(mesh, make_cube(), 1.0, {1, 1, 0});
  // Weld the shared edge: (1,1,0) and (1,1,1).
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = corner == 8 ? 3 : corner == 12 ? 7 : corner;
  }
  const MeshStatistics statistics = measure_statistics(mesh);
  CHECK(statistics.watertight);
  CHECK(statistics.non_manifold_edges == 1);
  CHECK(statistics.components == 1);
  CHECK(statistics.vertices == 14);
  CHECK(statistics.orientation == Orientation::outward);
}

TEST_CASE("Orientation") {
  TriangleMesh mesh = make_cube();
  SECTION("one face turned is mixed") {
    std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
    CHECK(measure_statistics(mesh).orientation == Orientation::mixed);
  }
  SECTION("all faces turned is inverted, wherever the mesh is") {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
    for (const double shift : {0.0, 1e3, -1e9}) {
      TriangleMesh moved = mesh;
      for (Eigen::Vector3d& vertex : moved.vertices) vertex.array() += shift;
      CHECK(measure_statistics(moved).orientation == Orientation::inverted);
    }
  }
  SECTION("a cavity is no inversion") {
    append(mesh, make_cube(), 0.5, {0.25, 0.25, 0.25}, true);
    CHECK(measure_statistics(mesh).orientation == Orientation::outward);
    CHECK(measure_statistics(mesh).components == 2);
  }
  SECTION("the larger part decides") {
    append(mesh, make_cube(), 2.0, {5, 5, 5}, true);
    CHECK(measure_statistics(mesh).orientation == Orientation::inverted);
  }
  SECTION("a box without lid is judged as a shell") {
    for (Eigen::Vector3d& vertex : mesh.vertices) vertex.array() += 100.0;
    mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
    CHECK(measure_statistics(mesh).orientation == Orientation::outward);
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
    CHECK(measure_statistics(mesh).orientation == Orientation::inverted);
  }
  SECTION("a sheet encloses nothing and is left alone") {
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}};
    CHECK(measure_statistics(mesh).orientation == Orientation::outward);
    mesh.triangles = {{0, 3, 2}, {0, 1, 3}};
    CHECK(measure_statistics(mesh).orientation == Orientation::outward);
  }
}

TEST_CASE("An empty mesh has statistics, too") {
  const MeshStatistics statistics = measure_statistics({});
  CHECK(statistics.faces == 0);
  CHECK(statistics.components == 0);
  CHECK_FALSE(statistics.watertight);
}

TEST_CASE("Statistics as JSON") {
  MeshStatistics statistics = measure_statistics(make_cube());
  statistics.faces_degenerate = 3;
  statistics.orientation = Orientation::mixed;
  const auto object = nlohmann::json::parse(to_json(statistics));
  CHECK(object.size() == 12);
  CHECK(object["vertices"] == 8);
  CHECK(object["faces"] == 12);
  CHECK(object["watertight"] == true);
  CHECK(object["orientation"] == "mixed");
  CHECK(object["faces_degenerate"] == 3);
}

}  // namespace mdbd::test
