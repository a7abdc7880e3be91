#include "perturbation/subdivision.h"

#include <catch2/catch.hpp>

#include "features/shape_io/mesh_statistics.h"
#include "tests/perturbation/meshes.h"

namespace mdbd::test {

TEST_CASE("subdivision keeps area, volume and closedness") {
  for (const TriangleMesh& mesh : {make_cube(), make_sphere(2), make_torus(2, 0.5, 12, 8)}) {
    const TriangleMesh fine = subdivide(mesh);
    const MeshStatistics before = measure_statistics(mesh);
    const MeshStatistics after = measure_statistics(fine);
    CHECK(after.faces == 4 * before.faces);
    CHECK(after.vertices == before.vertices + 3 * before.faces / 2);  // one more an edge
    CHECK(after.watertight);
    CHECK(after.orientation == Orientation::outward);
    CHECK(area(fine) == Approx(area(mesh)).epsilon(1e-12));
    CHECK(six_volumes(fine) == Approx(six_volumes(mesh)).epsilon(1e-12));
  }
}

TEST_CASE("subdivision keeps open edges open and faces that share an edge together") {
  TriangleMesh mesh = make_sheet(1);
  mesh.vertices.emplace_back(0, 0, 1);
  mesh.triangles.push_back({0, 3, 4});  // a third face at the diagonal
  const MeshStatistics before = measure_statistics(mesh);
  const MeshStatistics after = measure_statistics(subdivide(mesh));
  CHECK(after.open_edges == 2 * before.open_edges);
  CHECK(after.non_manifold_edges == 2 * before.non_manifold_edges);
}

TEST_CASE("an empty mesh stays empty") { CHECK(are_equal(subdivide({}), {})); }

}  // namespace mdbd::test
