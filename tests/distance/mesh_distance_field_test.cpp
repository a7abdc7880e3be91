#include "features/distance/mesh_distance_field.h"

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

std::vector<DistanceQuery> random_queries(std::size_t count, double size) {
  std::mt19937 random(1);
  std::vector<DistanceQuery> queries(count);
  for (DistanceQuery& query : queries) query.point = random_point(random, size);
  return queries;
}

}  // namespace

TEST_CASE("a mesh field measures signed distances") {
  const TriangleMesh mesh = make_torus(1.0, 0.4, 60, 30);
  const MeshDistanceField field(mesh, true);
  for (const DistanceQuery& query : random_queries(300, 1.5)) {
    const DistanceSample sample = field.measure(query);
    const double sign = mesh_winding(mesh, query.point) > 0.5 ? 1.0 : -1.0;
    CHECK(std::abs(sample.distance - sign * mesh_distance(mesh, query.point)) <= 1e-12);
    CHECK((sample.closest - query.point).norm() == Approx(std::abs(sample.distance)));
  }
  CHECK(field.enclosing_ball().radius == Approx(1.4).epsilon(1e-3));
}

TEST_CASE("the centroid is that of the surface, however it is divided") {
  // A square and a triangle that stands on it, far from the origin.
  const Eigen::Vector3d shift(1000, -2000, 500);
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 3}};
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex += shift;
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}};
  const Eigen::Vector3d expected =
      shift + (Eigen::Vector3d(0.5, 0.5, 0) + 1.5 * Eigen::Vector3d(1.0 / 3, 0, 1)) / 2.5;
  CHECK((MeshDistanceField(mesh, false).centroid() - expected).norm() < 1e-12);
  mesh.vertices.emplace_back(0.3 * mesh.vertices[0] + 0.7 * mesh.vertices[2]);
  mesh.triangles = {{0, 1, 5}, {5, 1, 2}, {5, 2, 3}, {0, 5, 3}, {0, 1, 4}};
  CHECK((MeshDistanceField(mesh, false).centroid() - expected).norm() < 1e-12);
}

TEST_CASE("the distance of a closed mesh is 1-Lipschitz across its boundary") {
  const MeshDistanceField field(make_torus(1.0, 0.4, 60, 30), true);
  const std::vector<DistanceQuery> queries = random_queries(400, 1.5);
  for (std::size_t i = 1; i < queries.size(); ++i) {
    const double first = field.measure(queries[i - 1]).distance;
    const double second = field.measure(queries[i]).distance;
    CHECK(std::abs(first - second) <= (queries[i - 1].point - queries[i].point).norm() + 1e-12);
  }
}

TEST_CASE("a batch gives the bits of single measurements, a known side is believed") {
  const MeshDistanceField field(make_torus(1.0, 0.4, 60, 30), true);
  std::vector<DistanceQuery> queries = random_queries(100, 1.5);
  std::vector<DistanceSample> samples(queries.size());
  field.measure(queries, samples);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    CHECK(field.measure(queries[i]).distance == samples[i].distance);
    queries[i].side = samples[i].distance > 0 ? Side::inside : Side::outside;
    queries[i].bound = 1.5 * std::abs(samples[i].distance);
    CHECK(field.measure(queries[i]).distance == samples[i].distance);
    CHECK(field.measure(queries[i]).closest == samples[i].closest);
  }
}

TEST_CASE("a neighbour tells the side of its empty ball alone") {
  const MeshDistanceField field(make_torus(1.0, 0.4, 60, 30), true);
  const std::vector<DistanceQuery> queries = random_queries(400, 1.5);
  for (std::size_t i = 1; i < queries.size(); ++i) {
    const DistanceSample neighbour = field.measure(queries[i - 1]);
    DistanceQuery query{.point = queries[i].point,
                        .neighbour = queries[i - 1].point,
                        .neighbour_distance = neighbour.distance};
    CHECK(field.measure(query).distance == field.measure(queries[i]).distance);
    // Across the closest boundary point the two balls touch there.
    query.point = 2.0 * neighbour.closest - query.neighbour;
    CHECK(field.measure(query).distance == field.measure({.point = query.point}).distance);
  }
}

TEST_CASE("a small hole does not turn the inside out") {
  TriangleMesh mesh = make_torus(1.0, 0.4, 60, 30);
  mesh.triangles.erase(mesh.triangles.begin() + 100, mesh.triangles.begin() + 104);
  const MeshDistanceField field(mesh, true);
  CHECK(field.measure({.point = {1.0, 0.0, 0.0}}).distance > 0.3);
  CHECK(field.measure({.point = {0.0, 0.0, 0.0}}).distance < -0.5);
}

TEST_CASE("a mesh without extent is refused") {
  CHECK_THROWS_AS(MeshDistanceField(TriangleMesh{}, true), InvalidInput);
  TriangleMesh point;
  point.vertices = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  point.triangles = {{0, 1, 2}};
  CHECK_THROWS_AS(MeshDistanceField(point, true), InvalidInput);
}
