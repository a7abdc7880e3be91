#include "features/distance/coplanar_triangles.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>

#include <catch2/catch.hpp>

#include "features/core/disjoint_sets.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;

namespace {

TriangleMesh random_soup(std::mt19937& random, std::uint32_t vertices, int triangles) {
  std::uniform_int_distribution<std::uint32_t> corner(0, vertices - 1);
  TriangleMesh mesh;
  mesh.vertices.resize(vertices, Eigen::Vector3d::Zero());
  for (int i = 0; i < triangles; ++i) {
    mesh.triangles.push_back({corner(random), corner(random), corner(random)});
  }
  return mesh;
}

}  // namespace

TEST_CASE("edges are visited once each, with all of their sides") {
  std::mt19937 random(1);
  const TriangleMesh mesh = random_soup(random, 20, 300);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::multiset<std::uint32_t>> expected;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      expected[std::minmax(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3])].insert(t);
    }
  }
  const std::vector<TriangleSide> sides = grouped_sides(mesh);
  CHECK(sides.size() == 3 * mesh.triangles.size());
  std::size_t visited = 0;
  for_each_edge(sides, [&](std::span<const TriangleSide> edge) {
    ++visited;
    const auto found = expected.find(std::minmax(edge[0].from, edge[0].to));
    REQUIRE(found != expected.end());
    std::multiset<std::uint32_t> triangles;
    for (const TriangleSide& side : edge) triangles.insert(side.triangle);
    CHECK(triangles == found->second);
    CHECK(std::ranges::is_sorted(edge, {}, &TriangleSide::triangle));
  });
  CHECK(visited == expected.size());
}

TEST_CASE("triangles are in one plane if they face the same way and no corner is off it") {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1e-9}, {2, 2, 2}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 2}, {0, 2, 4}, {0, 0, 1}};
  const CoplanarityTest test(mesh);
  CHECK(test.is_in_plane(1, 0));
  CHECK(!test.is_in_plane(2, 0));  // it faces the other way
  CHECK(!test.is_in_plane(3, 0));
  CHECK(!test.is_in_plane(4, 0));  // no area, no plane
}

TEST_CASE("sets are joined as a relation is") {
  std::mt19937 random(2);
  constexpr std::uint32_t count = 60;
  DisjointSets sets(count);
  std::vector<std::uint32_t> label(count);
  for (std::uint32_t i = 0; i < count; ++i) label[i] = i;
  std::uniform_int_distribution<std::uint32_t> number(0, count - 1);
  for (int i = 0; i < 50; ++i) {
    const std::uint32_t a = number(random);
    const std::uint32_t b = number(random);
    const std::uint32_t root = sets.root(a);
    sets.join(a, b);
    const std::uint32_t old_label = label[b];
    const std::uint32_t new_label = label[a];
    std::ranges::replace(label, old_label, new_label);
    CHECK(sets.root(b) == root);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t j = 0; j < count; ++j) {
      CHECK((sets.root(i) == sets.root(j)) == (label[i] == label[j]));
    }
  }
}
