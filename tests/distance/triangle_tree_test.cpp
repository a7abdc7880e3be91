#include <catch2/catch.hpp>

#include "features/distance/closest_point.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

TriangleMesh random_soup(std::mt19937& random, std::size_t count, double size) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Eigen::Vector3d corner = random_point(random, 1.0);
    mesh.vertices.push_back(corner);
    mesh.vertices.push_back(corner + random_point(random, size));
    mesh.vertices.push_back(corner + random_point(random, size));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

// Triangles a million times longer than wide.
TriangleMesh needles(std::mt19937& random, std::uint32_t count) {
  TriangleMesh mesh = random_soup(random, count, 0.5);
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.vertices[3 * i + 2] = mesh.vertices[3 * i + 1] + random_point(random, 5e-7);
  }
  return mesh;
}

// Triangles whose corners are on a line, but for rounding.
TriangleMesh slivers(std::mt19937& random, std::uint32_t count) {
  TriangleMesh mesh = random_soup(random, count, 0.5);
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.vertices[3 * i + 2] = (mesh.vertices[3 * i] + mesh.vertices[3 * i + 1]) / 2.0;
  }
  return mesh;
}

void check_against_brute_force(const TriangleMesh& mesh, std::mt19937& random, double reach) {
  const TriangleTree tree(mesh);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d point = random_point(random, reach);
    const double expected = mesh_distance(mesh, point);
    const ClosestPoint found = find_closest_point(tree, point);
    const double scale = std::max(1.0, reach);
    INFO("point " << point.transpose());
    CHECK(std::abs(std::sqrt(found.squared_distance) - expected) <= 1e-12 * scale);
    CHECK((found.point - point).squaredNorm() == Approx(found.squared_distance));
    CHECK(mesh_distance(mesh, found.point) <= 1e-12 * scale);
  }
}

}  // namespace

TEST_CASE("closest points agree with brute force") {
  std::mt19937 random(1);
  SECTION("small triangles") {
    check_against_brute_force(random_soup(random, 2000, 0.05), random, 1.5);
  }
  SECTION("large triangles") {
    check_against_brute_force(random_soup(random, 200, 1.0), random, 1.5);
  }
  SECTION("needles") { check_against_brute_force(needles(random, 300), random, 1.5); }
  SECTION("slivers") { check_against_brute_force(slivers(random, 300), random, 1.5); }
  SECTION("far away") { check_against_brute_force(random_soup(random, 300, 0.1), random, 1e6); }
  SECTION("one triangle") { check_against_brute_force(random_soup(random, 1, 1.0), random, 2.0); }
  SECTION("a torus") { check_against_brute_force(make_torus(1.0, 0.3, 40, 20), random, 1.5); }
}

TEST_CASE("distances keep their relative precision in any unit") {
  for (const double unit : {1e-12, 1e12}) {
    TriangleMesh mesh = make_torus(1.0, 0.3, 30, 15);
    for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= unit;
    const TriangleTree tree(mesh);
    std::mt19937 random(2);
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector3d point = unit * random_point(random, 1.5);
      const double found = std::sqrt(find_closest_point(tree, point).squared_distance);
      CHECK(std::abs(found - mesh_distance(mesh, point)) <= 1e-12 * unit);
    }
  }
}

TEST_CASE("a warm start does not change the answer") {
  const TriangleMesh mesh = make_torus(1.0, 0.3, 40, 20);
  const TriangleTree tree(mesh);
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d point = random_point(random, 1.5);
    const ClosestPoint cold = find_closest_point(tree, point);
    const double distance = std::sqrt(cold.squared_distance);
    for (const double bound : {distance, 1.1 * distance, 10.0 * distance}) {
      const ClosestPoint warm = find_closest_point(tree, point, bound);
      CHECK(warm.squared_distance == cold.squared_distance);
    }
  }
}

TEST_CASE("many triangles in one place make no deep tree") {
  TriangleMesh mesh = make_cube();
  const std::vector<Triangle> faces = mesh.triangles;
  for (int copy = 0; copy < 500; ++copy) {
    mesh.triangles.insert(mesh.triangles.end(), faces.begin(), faces.end());
  }
  // A geometric sequence is the worst case for the surface area heuristic.
  double size = 1.0;
  for (int i = 0; i < 900; ++i, size *= 0.5) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(size, 0, 0);
    mesh.vertices.emplace_back(size, size, 0);
    mesh.vertices.emplace_back(size, 0, size);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const TriangleTree tree(mesh);
  CHECK(find_closest_point(tree, {0.5, 0.5, 2.0}).squared_distance == Approx(1.0));
}

TEST_CASE("every triangle is in exactly one leaf") {
  const TriangleMesh mesh = make_torus(1.0, 0.3, 50, 30);
  const TriangleTree tree(mesh);
  std::vector<int> seen(mesh.triangles.size(), 0);
  for (const TreeNode& node : tree.nodes()) {
    for (int child = 0; child < TreeNode::width; ++child) {
      if (node.inner[child] != 0) continue;
      for (std::uint32_t i = 0; i < node.count[child]; ++i) ++seen[node.first[child] + i];
    }
  }
  CHECK(std::all_of(seen.begin(), seen.end(), [](int count) { return count == 1; }));
}
