#include "evaluation/certificate/mesh_measure.h"

#include <random>

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;

namespace {

/// Random triangles, some of them without area.
TriangleMesh make_soup() {
  std::mt19937 random(1);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 60; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(test::random_point(random, 1.0));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, i % 10 == 0 ? 3 * i : 3 * i + 2});
  }
  return mesh;
}

}  // namespace

TEST_CASE("distances and winding numbers are those of every triangle, added up") {
  const TriangleMesh mesh = GENERATE(make_soup(), test::make_torus(2, 0.7, 24, 12));
  std::mt19937 random(2);
  const MeshMeasure measure(mesh);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d x = test::random_point(random, 3.0);
    const double distance = test::mesh_distance(mesh, x);
    CHECK(measure.distance(x) == Approx(distance).epsilon(1e-12));
    CHECK(measure.is_clear(x, 0.999999 * distance));
    CHECK_FALSE(measure.is_clear(x, 1.000001 * distance));
    CHECK(measure.winding_number(x) == Approx(test::mesh_winding(mesh, x)).margin(1e-9));
  }
}

TEST_CASE("the winding number counts how often a surface is wrapped around a point") {
  TriangleMesh mesh;
  for (const double size : {1.0, 3.0, 9.0}) {  // one in another, far from the origin
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    TriangleMesh cube = test::make_cube();
    for (const Eigen::Vector3d& vertex : cube.vertices) {
      mesh.vertices.push_back(size * (vertex - Eigen::Vector3d::Constant(0.5)) +
                              Eigen::Vector3d::Constant(1e4));
    }
    for (const auto& [a, b, c] : cube.triangles) {
      mesh.triangles.push_back({first + a, first + b, first + c});
    }
  }
  const MeshMeasure measure(mesh);
  const auto winding = [&](double x) {
    return measure.winding_number(Eigen::Vector3d(1e4 + x, 1e4 + 0.1, 1e4 - 0.2));
  };
  CHECK(winding(0.1) == Approx(3.0));
  CHECK(winding(1.0) == Approx(2.0));
  CHECK(winding(4.0) == Approx(1.0));
  CHECK(winding(5.0) == Approx(0.0).margin(1e-9));
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  CHECK(winding(0.1) == Approx(-3.0));
}
