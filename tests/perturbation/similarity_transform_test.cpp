#include "perturbation/similarity_transform.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/distance/enclosing_ball.h"
#include "tests/perturbation/meshes.h"

namespace mdbd::test {
namespace {

/// Whether all distances between vertices are `factor` times those of before.
bool keeps_distances(const TriangleMesh& before, const TriangleMesh& after, double factor) {
  for (std::size_t i = 0; i < before.vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double old_distance = (before.vertices[i] - before.vertices[j]).norm();
      const double distance = (after.vertices[i] - after.vertices[j]).norm();
      if (std::abs(distance - factor * old_distance) > 1e-12 * factor * (1 + old_distance)) {
        return false;
      }
    }
  }
  return true;
}

Eigen::Vector3d middle(const TriangleMesh& mesh) { return enclosing_ball(mesh.vertices).center; }

}  // namespace

TEST_CASE("a rotation keeps distances, volume and middle") {
  const TriangleMesh mesh = make_torus(2, 0.5, 12, 8);
  const TriangleMesh rotated = rotate(mesh, 3);
  CHECK(rotated.triangles == mesh.triangles);
  CHECK(keeps_distances(mesh, rotated, 1));
  CHECK(six_volumes(rotated) == Approx(six_volumes(mesh)).epsilon(1e-12));
  CHECK((middle(rotated) - middle(mesh)).norm() < 1e-9);
  CHECK((rotated.vertices[0] - mesh.vertices[0]).norm() > 0.01);
  CHECK_FALSE(are_equal(rotated, rotate(mesh, 4)));
  CHECK(are_equal(rotated, rotate(mesh, 3)));
}

TEST_CASE("a translation moves all vertices alike") {
  const TriangleMesh mesh = make_sphere(2);
  const TriangleMesh moved = translate(mesh, 10, 3);
  const Eigen::Vector3d shift = moved.vertices[0] - mesh.vertices[0];
  CHECK(shift.norm() == Approx(20));
  CHECK(moved.triangles == mesh.triangles);
  CHECK(keeps_distances(mesh, moved, 1));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    CHECK((moved.vertices[i] - mesh.vertices[i] - shift).norm() < 1e-12);
  }
}

TEST_CASE("a scale multiplies distances") {
  const TriangleMesh mesh = make_cube();
  CHECK(keeps_distances(mesh, scale(mesh, 25.4), 25.4));
  CHECK(six_volumes(scale(mesh, 0.5)) == 6.0 / 8);
}

TEST_CASE("a mirrored mesh stays outward and is no rotated one") {
  TriangleMesh mesh = make_cube();
  mesh.vertices[7] = {2, 3, 4};  // no symmetry is left
  const TriangleMesh mirrored = mirror(mesh, 5);
  CHECK(keeps_distances(mesh, mirrored, 1));
  CHECK(six_volumes(mirrored) == Approx(six_volumes(mesh)).epsilon(1e-12));
  const auto handedness = [](const TriangleMesh& m) {
    Eigen::Matrix3d edges;
    for (int i = 0; i < 3; ++i) edges.col(i) = m.vertices[1 << i] - m.vertices[0];
    return edges.determinant();
  };
  CHECK(handedness(mirrored) == Approx(-handedness(mesh)));
  CHECK((middle(mirrored) - middle(mesh)).norm() < 1e-9);
}

TEST_CASE("moves that make no sense are refused") {
  const double nan = std::nan("");
  for (const double factor : {0.0, -1.0, 1e7, nan}) {
    CHECK_THROWS_AS(scale(make_cube(), factor), InvalidInput);
  }
  for (const double distance : {-1.0, 1e7, nan}) {
    CHECK_THROWS_AS(translate(make_cube(), distance, 1), InvalidInput);
  }
}

}  // namespace mdbd::test
