#include "perturbation/noise.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "tests/perturbation/meshes.h"

namespace mdbd::test {

TEST_CASE("no vertex moves by more than the bound, and some by nearly as much") {
  TriangleMesh mesh = make_sphere(4);
  for (auto& vertex : mesh.vertices) vertex = 5 * vertex + Eigen::Vector3d(100, 0, 0);
  const double bound = 0.01 * 10;  // 1 % of the diameter
  const TriangleMesh noisy = displace_vertices(mesh, 0.01, 7);
  CHECK(noisy.triangles == mesh.triangles);
  double largest = 0.0;
  int inner = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Eigen::Vector3d shift = noisy.vertices[i] - mesh.vertices[i];
    largest = std::max(largest, shift.norm());
    inner += shift.norm() < bound * std::cbrt(0.5) ? 1 : 0;
    mean += shift / static_cast<double>(mesh.vertices.size());
  }
  CHECK(largest <= bound * (1 + 1e-9));
  CHECK(largest > 0.99 * bound);
  CHECK(inner == Approx(mesh.vertices.size() / 2.0).epsilon(0.1));
  CHECK(mean.norm() < 0.1 * bound);
}

TEST_CASE("the same seed gives the same noise, another seed another") {
  const TriangleMesh mesh = make_cube();
  CHECK(are_equal(displace_vertices(mesh, 0.01, 1), displace_vertices(mesh, 0.01, 1)));
  CHECK_FALSE(are_equal(displace_vertices(mesh, 0.01, 1), displace_vertices(mesh, 0.01, 2)));
  CHECK(are_equal(displace_vertices(mesh, 0, 1), mesh));
}

TEST_CASE("noise that makes no sense is refused") {
  for (const double bound : {-0.1, 1.1, std::nan("")}) {
    CHECK_THROWS_AS(displace_vertices(make_cube(), bound, 1), InvalidInput);
  }
}

}  // namespace mdbd::test
