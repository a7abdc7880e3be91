#include "perturbation/decimation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/core/random.h"
#include "features/shape_io/mesh_statistics.h"
#include "tests/perturbation/meshes.h"

namespace mdbd::test {
namespace {

/// Appends a mesh to another, moved.
void append(TriangleMesh& mesh, const TriangleMesh& other, const Eigen::Vector3d& shift) {
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const auto& vertex : other.vertices) mesh.vertices.emplace_back(vertex + shift);
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({a + offset, b + offset, c + offset});
  }
}

bool has_vertices_of(const TriangleMesh& part, const TriangleMesh& whole) {
  return std::ranges::all_of(part.vertices, [&](const Eigen::Vector3d& vertex) {
    return std::ranges::find(whole.vertices, vertex) != whole.vertices.end();
  });
}

}  // namespace

TEST_CASE("a decimated sphere is closed, of the size asked for and nearly as large") {
  const TriangleMesh sphere = make_sphere(5);  // 8192 triangles
  for (const double fraction : {0.5, 0.1}) {
    const TriangleMesh coarse = decimate(sphere, fraction);
    INFO(fraction);
    CHECK(coarse.triangles.size() <= std::round(fraction * 8192));
    CHECK(coarse.triangles.size() >= std::round(fraction * 8192) - 1);
    const MeshStatistics statistics = measure_statistics(coarse);
    CHECK(statistics.watertight);
    CHECK(statistics.non_manifold_edges == 0);
    CHECK(statistics.components == 1);
    CHECK(statistics.orientation == Orientation::outward);
    CHECK(statistics.vertices == coarse.vertices.size());
    CHECK(has_vertices_of(coarse, sphere));
    CHECK(six_volumes(coarse) / 6 == Approx(4 * std::numbers::pi / 3).epsilon(0.02));
  }
}

TEST_CASE("flat faces lose their inner vertices and nothing else") {
  TriangleMesh cube = make_cube();
  for (int i = 0; i < 4; ++i) cube = subdivide(cube);
  for (auto& vertex : cube.vertices) vertex = 1e-3 * vertex + Eigen::Vector3d(50, 60, 70);
  const TriangleMesh coarse = decimate(cube, 0.1);
  CHECK(coarse.triangles.size() <= cube.triangles.size() / 10);
  CHECK(measure_statistics(coarse).watertight);
  CHECK(area(coarse) == Approx(6e-6).epsilon(1e-6));
}

TEST_CASE("an open mesh keeps its outline") {
  const TriangleMesh coarse = decimate(make_sheet(20), 0.02);
  CHECK(coarse.triangles.size() <= 16);
  CHECK(area(coarse) == Approx(400));
  CHECK(measure_statistics(coarse).components == 1);

  TriangleMesh bowl = make_sphere(4);
  std::erase_if(bowl.triangles, [&](const Triangle& triangle) {
    return std::ranges::any_of(triangle,
                               [&](auto corner) { return bowl.vertices[corner].z() > 0; });
  });
  const TriangleMesh coarse_bowl = decimate(bowl, 0.2);
  CHECK(coarse_bowl.triangles.size() <= bowl.triangles.size() / 5);
  CHECK(area(coarse_bowl) == Approx(2 * std::numbers::pi).epsilon(0.05));
  CHECK(measure_statistics(coarse_bowl).components == 1);
}

TEST_CASE("where the mesh is no manifold nothing comes open") {
  // Two spheres that touch at a vertex, and a wall that joins two of the sphere's faces at an edge.
  TriangleMesh mesh = make_sphere(3);
  const TriangleMesh sphere = mesh;
  append(mesh, sphere, {2, 0, 0});
  const auto touching = [](const Eigen::Vector3d& v) { return v == Eigen::Vector3d(1, 0, 0); };
  const auto first = std::ranges::find_if(mesh.vertices, touching);
  const auto second = std::find_if(first + 1, mesh.vertices.end(), touching);
  REQUIRE(second != mesh.vertices.end());
  const auto kept = static_cast<std::uint32_t>(first - mesh.vertices.begin());
  const auto merged = static_cast<std::uint32_t>(second - mesh.vertices.begin());
  for (Triangle& triangle : mesh.triangles) std::ranges::replace(triangle, merged, kept);
  REQUIRE(measure_statistics(mesh).components == 1);
  const TriangleMesh coarse = decimate(mesh, 0.2);
  CHECK(coarse.triangles.size() <= mesh.triangles.size() / 5);
  CHECK(measure_statistics(coarse).watertight);
  CHECK(measure_statistics(coarse).components == 1);

  TriangleMesh cubes = make_cube();  // two cubes with an edge in common: four faces meet there
  append(cubes, make_cube(), {1, 1, 0});
  for (Triangle& triangle : cubes.triangles) {
    std::ranges::replace(triangle, 8U, 3U);
    std::ranges::replace(triangle, 12U, 7U);
  }
  for (int i = 0; i < 4; ++i) cubes = subdivide(cubes);
  REQUIRE(measure_statistics(cubes).non_manifold_edges == 16);
  const TriangleMesh coarse_cubes = decimate(cubes, 0.1);
  CHECK(coarse_cubes.triangles.size() <= cubes.triangles.size() / 10);
  CHECK(measure_statistics(coarse_cubes).watertight);
  CHECK(measure_statistics(coarse_cubes).non_manifold_edges == 16);
  CHECK(area(coarse_cubes) == Approx(12).epsilon(1e-6));
}

TEST_CASE("soups and tiny meshes survive") {
  Random random(4);
  TriangleMesh soup;  // random faces over few vertices: many at an edge, in both directions
  for (int i = 0; i < 30; ++i) {
    soup.vertices.emplace_back(random.uniform(), random.uniform(), random.uniform());
  }
  for (int i = 0; i < 3000; ++i) {
    const auto corner = [&] { return static_cast<std::uint32_t>(random.index(30)); };
    const Triangle triangle{corner(), corner(), corner()};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
      soup.triangles.push_back(triangle);
    }
  }
  const TriangleMesh coarse = decimate(soup, 0.1);
  CHECK(coarse.triangles.size() <= soup.triangles.size());
  CHECK(has_vertices_of(coarse, soup));

  const TriangleMesh tetrahedron{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  CHECK(decimate(tetrahedron, 0.1).triangles.size() == 4);
  TriangleMesh many;
  for (int i = 0; i < 50; ++i) append(many, tetrahedron, {2.0 * i, 0, 0});
  CHECK(decimate(many, 0.1).triangles.size() == 200);
  const TriangleMesh triangle{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                              .triangles = {{0, 1, 2}}};
  CHECK(are_equal(decimate(triangle, 0.5), triangle));
}

TEST_CASE("decimation is repeatable and keeps a mesh that is to keep all faces") {
  const TriangleMesh sphere = make_sphere(4);
  CHECK(are_equal(decimate(sphere, 0.3), decimate(sphere, 0.3)));
  CHECK(are_equal(decimate(sphere, 1), sphere));
  for (const double fraction : {0.0, -1.0, 1.1, std::nan("")}) {
    CHECK_THROWS_AS(decimate(sphere, fraction), InvalidInput);
  }
}

}  // namespace mdbd::test
