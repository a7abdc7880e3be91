#include "features/shape_io/clean_mesh.h"

#include <initializer_list>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "tests/support/sample_meshes.h"

namespace mdbd::test {
namespace {

PolygonMesh make_polygons(std::vector<Eigen::Vector3d> vertices,
                          std::initializer_list<std::vector<std::uint32_t>> faces) {
  PolygonMesh mesh;
  mesh.vertices = std::move(vertices);
  for (const std::vector<std::uint32_t>& face : faces) {
    mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    mesh.face_ends.push_back(mesh.corners.size());
  }
  mesh.file_vertices = mesh.vertices.size();
  mesh.file_faces = mesh.face_count();
  return mesh;
}

}  // namespace

TEST_CASE("Vertices of the same place are welded, zeros of both signs too") {
  const CleanedMesh cleaned = clean_mesh(make_polygons(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, -0.0, 0}, {0, 1, -0.0}, {0, 0, 1}, {1e-300, 0, 0}},
      {{0, 1, 2}, {3, 4, 5}, {6, 1, 5}}));
  CHECK(cleaned.statistics.vertices_welded == 2);
  CHECK(cleaned.statistics.vertices == 5);
  CHECK(cleaned.mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {4, 1, 3}});
}

TEST_CASE("Faces without area are dropped, thin ones are kept") {
  const CleanedMesh cleaned = clean_mesh(make_polygons(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1e-9, 0}, {0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}},
      {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 0, 1}, {1, 2}, {}}));
  CHECK(cleaned.statistics.faces_degenerate == 5);
  CHECK(cleaned.statistics.faces == 1);
  CHECK(cleaned.mesh.vertices.size() == 3);
  CHECK(cleaned.statistics.vertices_unused == 3);
}

TEST_CASE("Whether a face has area does not depend on its size or place") {
  for (const double scale : {1e-200, 1e-30, 1.0, 1e30}) {
    const CleanedMesh cleaned = clean_mesh(make_polygons(
        {{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {0.5 * scale, 0, 0}}, {{0, 1, 2}, {0, 3, 1}}));
    CHECK(cleaned.statistics.faces == 1);
    CHECK(cleaned.statistics.faces_degenerate == 1);
  }
}

TEST_CASE("A closed mesh does not seem open because a flat face went") {
  // The cube with a vertex on an edge of its bottom, which a flat face joins to the other side.
  TriangleMesh cube = make_cube();
  PolygonMesh polygons = make_polygons(cube.vertices, {});
  polygons.vertices.emplace_back(0.5, 0, 0);
  cube.triangles[1] = {0, 3, 8};
  cube.triangles.push_back({8, 3, 1});
  cube.triangles.push_back({0, 8, 1});
  for (const Triangle& triangle : cube.triangles) {
    polygons.corners.insert(polygons.corners.end(), triangle.begin(), triangle.end());
    polygons.face_ends.push_back(polygons.corners.size());
  }
  polygons.file_vertices = polygons.vertices.size();
  polygons.file_faces = polygons.face_count();
  const CleanedMesh cleaned = clean_mesh(polygons);
  CHECK(cleaned.statistics.faces_degenerate == 1);
  CHECK(cleaned.statistics.faces == 13);
  CHECK(cleaned.statistics.watertight);
  CHECK(cleaned.statistics.open_edges == 0);
}

TEST_CASE("A polygon with a bad index is dropped as a whole") {
  const CleanedMesh cleaned =
      clean_mesh(make_polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                               {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 0xffffffff}}));
  CHECK(cleaned.statistics.faces == 2);
  CHECK(cleaned.statistics.faces_invalid == 2);
  CHECK(cleaned.statistics.polygons_triangulated == 1);
}

TEST_CASE("What a reader dropped and merged counts too") {
  PolygonMesh polygons = make_polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}});
  polygons.file_vertices = 9;
  polygons.file_faces = 3;
  const CleanedMesh cleaned = clean_mesh(polygons);
  CHECK(cleaned.statistics.vertices_welded == 6);
  CHECK(cleaned.statistics.faces_degenerate == 2);
}

TEST_CASE("If no face remains, the reason says what was wrong") {
  CHECK_THROWS_AS(clean_mesh(make_polygons({{0, 0, 0}}, {{0, 0, 0}, {0, 1, 2}})), InvalidInput);
  CHECK_THROWS_WITH(clean_mesh(make_polygons({{0, 0, 0}}, {{0, 0, 0}, {0, 1, 2}})),
                    "no face can be used: 1 without area, 1 with an index outside the vertex list");
}

}  // namespace mdbd::test
