#include "features/distance/winding_number.h"

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

// How well dipoles stand in for groups of triangles.
constexpr double accuracy = 0.1;

void check_against_brute_force(const TriangleMesh& mesh, double reach) {
  const TriangleTree tree(mesh);
  const WindingNumber winding(tree);
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d point = random_point(random, reach);
    INFO("point " << point.transpose());
    CHECK(winding(point) == Approx(mesh_winding(mesh, point)).margin(accuracy));
  }
}

void append(TriangleMesh& mesh, const TriangleMesh& other, const Eigen::Vector3d& offset) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : other.vertices) mesh.vertices.push_back(vertex + offset);
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
}

}  // namespace

TEST_CASE("winding numbers agree with the sum of all solid angles") {
  TriangleMesh mesh = make_torus(1.0, 0.4, 60, 30);
  SECTION("closed") { check_against_brute_force(mesh, 2.0); }
  SECTION("a hole") {
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 200);
    check_against_brute_force(mesh, 2.0);
  }
  SECTION("inverted") {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
    check_against_brute_force(mesh, 2.0);
  }
  SECTION("overlapping parts") {
    append(mesh, make_torus(1.0, 0.4, 60, 30), {0.3, 0.2, 0.1});
    check_against_brute_force(mesh, 2.0);
  }
}

TEST_CASE("the winding number of a closed surface is 1 inside and 0 outside") {
  const TriangleMesh mesh = make_torus(1.0, 0.4, 200, 80);
  const TriangleTree tree(mesh);
  const WindingNumber winding(tree);
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d point = random_point(random, 2.0);
    const double from_core = std::hypot(std::hypot(point.x(), point.y()) - 1.0, point.z());
    if (std::abs(from_core - 0.4) < 0.01) continue;
    CHECK(winding(point) == Approx(from_core < 0.4 ? 1.0 : 0.0).margin(accuracy));
  }
}

TEST_CASE("overlapping parts count twice where they overlap") {
  TriangleMesh mesh = make_cube();
  append(mesh, make_cube(), {0.5, 0.5, 0.5});
  const TriangleTree tree(mesh);
  const WindingNumber winding(tree);
  CHECK(winding({0.25, 0.25, 0.25}) == Approx(1.0).margin(accuracy));
  CHECK(winding({0.75, 0.75, 0.75}) == Approx(2.0).margin(accuracy));
  CHECK(winding({1.25, 1.25, 1.25}) == Approx(1.0).margin(accuracy));
  CHECK(winding({1.25, 0.25, 0.25}) == Approx(0.0).margin(accuracy));
}
