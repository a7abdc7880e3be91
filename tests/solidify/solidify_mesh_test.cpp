#include "features/solidify/solidify_mesh.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/sample_meshes.h"
#include "tests/support/sheets.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

constexpr double minimum_radius = 1e-3;

double share_of(const TriangleMesh& mesh, bool is_closed = false) {
  return measure_enclosing_share(mesh, is_closed, minimum_radius);
}

TriangleMesh without_faces(TriangleMesh mesh, double above_z) {
  std::erase_if(mesh.triangles, [&](const Triangle& triangle) {
    return std::ranges::all_of(
        triangle, [&](std::uint32_t corner) { return mesh.vertices[corner].z() > above_z; });
  });
  return mesh;
}

TriangleMesh make_box(double x, double y, double z) {
  TriangleMesh mesh = make_cube();
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex = vertex.cwiseProduct(Eigen::Vector3d(x, y, z));
  return mesh;
}

}  // namespace

TEST_CASE("solids enclose something, however they are made") {
  CHECK(share_of(make_cube(), true) == 1.0);
  CHECK(share_of(make_cube()) == 1.0);
  CHECK(share_of(make_box(1, 1, 0.01), true) == 1.0);
  CHECK(share_of(make_torus(1.0, 0.4, 20, 10)) == 1.0);
  CHECK(share_of(make_sphere(1.0, 6)) == 1.0);  // its sides share no vertices
  INFO("an open vessel is filled");
  CHECK(share_of(without_faces(make_sphere(1.0, 10), 0.05)) > 0.8);
  CHECK(share_of(without_faces(make_cube(), 0.5)) > 0.8);
}

TEST_CASE("sheets enclose nothing") {
  CHECK(share_of(make_square()) == 0.0);
  CHECK(share_of(make_sheet_table()) < 0.2);
  INFO("a double sheet, and a plate too thin for a ball");
  TriangleMesh twice = make_square();
  for (const auto& [a, b, c] : make_square().triangles) twice.triangles.push_back({a, c, b});
  CHECK(share_of(twice, true) == 0.0);
  CHECK(share_of(make_box(1, 1, 1e-3), true) < 0.01);
  INFO("a shallow dish");
  CHECK(share_of(without_faces(make_sphere(1.0, 12), -0.7)) < 0.1);
}

TEST_CASE("a solid stays as it is") {
  const TriangleMesh torus = make_torus(1.0, 0.4, 20, 10);
  const SolidifiedMesh result = solidify_mesh(torus, true, minimum_radius);
  CHECK(result.thickness == 0.0);
  CHECK(result.mesh.vertices == torus.vertices);
  CHECK(result.mesh.triangles == torus.triangles);
}

TEST_CASE("a sheet gets a thickness relative to its size") {
  for (const double size : {1e-3, 1.0, 1e3}) {
    TriangleMesh square = make_square();
    for (Eigen::Vector3d& vertex : square.vertices) vertex *= size;
    const SolidifiedMesh result = solidify_mesh(square, false, minimum_radius);
    CHECK(result.thickness == Approx(sheet_thickness * size * std::sqrt(0.5)));
    CHECK(six_volumes(result.mesh) / 6.0 == Approx(result.thickness * size * size));
  }
}

TEST_CASE("the solid parts of a sheet model stay as they are") {
  TriangleMesh mesh = make_box(0.1, 0.1, 0.8);
  add_parallelogram(mesh, {0, 0, 0.8}, {2, 0, 0}, {0, 2, 0});
  const SolidifiedMesh result = solidify_mesh(mesh, false, minimum_radius);
  CHECK(result.thickness > 0.0);
  CHECK(six_volumes(result.mesh) / 6.0 == Approx(0.008 + 4 * result.thickness));
}

TEST_CASE("every part of a sheet model is thickened, however many there are") {
  TriangleMesh mesh;
  constexpr int across = 55;
  for (int i = 0; i < across * across; ++i) {
    const Eigen::Vector3d origin = Eigen::Vector3i(i % across, i / across, 0).cast<double>();
    add_parallelogram(mesh, origin, {0.5, 0, 0}, {0, 0.5, 0});
  }
  const SolidifiedMesh result = solidify_mesh(mesh, false, minimum_radius);
  REQUIRE(result.thickness > 0.0);
  CHECK(six_volumes(result.mesh) / 6.0 == Approx(across * across * 0.25 * result.thickness));
}
