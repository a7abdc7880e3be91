#include "perturbation/shuffling.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/perturbation/meshes.h"

namespace mdbd::test {
namespace {

using Corner = std::array<double, 3>;

/// The triangles by their corners' places, each begun at its smallest corner, in order.
std::vector<std::array<Corner, 3>> sorted_faces(const TriangleMesh& mesh) {
  std::vector<std::array<Corner, 3>> faces;
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Corner, 3> face;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d& vertex = mesh.vertices[triangle[i]];
      face[i] = {vertex.x(), vertex.y(), vertex.z()};
    }
    std::ranges::rotate(face, std::ranges::min_element(face));
    faces.push_back(face);
  }
  std::ranges::sort(faces);
  return faces;
}

}  // namespace

TEST_CASE("a shuffled mesh has the same faces in another order") {
  const TriangleMesh mesh = make_sphere(3);
  const TriangleMesh shuffled = shuffle(mesh, 1);
  CHECK(sorted_faces(shuffled) == sorted_faces(mesh));
  CHECK_FALSE(shuffled.vertices == mesh.vertices);
  CHECK_FALSE(shuffled.triangles == mesh.triangles);
  CHECK(are_equal(shuffled, shuffle(mesh, 1)));
  CHECK_FALSE(are_equal(shuffled, shuffle(mesh, 2)));
}

TEST_CASE("every order of three vertices comes") {
  const TriangleMesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}};
  std::set<std::vector<double>> orders;
  std::set<Triangle> triangles;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const TriangleMesh shuffled = shuffle(mesh, seed);
    std::vector<double> order;
    for (const auto& vertex : shuffled.vertices) order.push_back(vertex.x() + 2 * vertex.y());
    orders.insert(order);
    triangles.insert(shuffled.triangles[0]);
    CHECK(sorted_faces(shuffled) == sorted_faces(mesh));
  }
  CHECK(orders.size() == 6);
  CHECK(triangles.size() == 6);
}

TEST_CASE("tiny meshes can be shuffled") {
  CHECK(are_equal(shuffle({}, 1), {}));
  const TriangleMesh point{.vertices = {{1, 2, 3}}, .triangles = {}};
  CHECK(are_equal(shuffle(point, 1), point));
}

}  // namespace mdbd::test
