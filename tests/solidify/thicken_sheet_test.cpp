#include "features/solidify/thicken_sheet.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "features/distance/mesh_distance_field.h"
#include "features/shape_io/mesh_statistics.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/sheets.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

double volume(const TriangleMesh& mesh) { return six_volumes(mesh) / 6.0; }

bool is_closed_and_outward(const TriangleMesh& mesh) {
  const MeshStatistics statistics = measure_statistics(mesh);
  return statistics.watertight && statistics.orientation == Orientation::outward;
}

double depth_at(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  return MeshDistanceField(mesh, true).measure({.point = point}).distance;
}

}  // namespace

TEST_CASE("a thick square is a plate") {
  const TriangleMesh plate = thicken_sheet(make_square(), 0.1);
  CHECK(is_closed_and_outward(plate));
  CHECK(plate.triangles.size() == 12);
  CHECK(volume(plate) == Approx(0.2).epsilon(1e-12));
  for (const double x : {0.2, 0.5, 0.7}) {
    CHECK(depth_at(plate, {x, 0.5, 0.0}) == Approx(0.1).epsilon(1e-12));
  }
  CHECK(depth_at(plate, {0.5, 0.5, 0.11}) == Approx(-0.01).epsilon(1e-9));
}

TEST_CASE("a thick fold is mitred on both sides") {
  const TriangleMesh angle = thicken_sheet(make_fold(), 0.1);
  CHECK(is_closed_and_outward(angle));
  // Two plates of 0.2 whose middles meet in the axis: inside one loses what the other gains.
  CHECK(volume(angle) == Approx(0.4).epsilon(1e-12));
  CHECK(depth_at(angle, {0.5, 0.5, 0.0}) == Approx(0.1).epsilon(1e-12));
  CHECK(depth_at(angle, {0.0, 0.5, 0.0}) == Approx(0.1).epsilon(1e-12));
  // The ball between the outer sides and the inner edge at (0.1, 0.1).
  const double radius = 0.2 * std::sqrt(2.0) / (1 + std::sqrt(2.0));
  CHECK(depth_at(angle, {radius - 0.1, 0.5, radius - 0.1}) == Approx(radius).epsilon(1e-12));
}

TEST_CASE("a closed surface becomes a shell with a cavity") {
  const TriangleMesh shell = thicken_sheet(make_cube(), 0.1);
  CHECK(is_closed_and_outward(shell));
  CHECK(volume(shell) == Approx(std::pow(1.2, 3) - std::pow(0.8, 3)).epsilon(1e-12));
}

TEST_CASE("faces that are turned or doubled do not matter for a sheet") {
  const double expected = volume(thicken_sheet(make_fold(), 0.1));
  TriangleMesh turned = make_fold();
  std::swap(turned.triangles[1][0], turned.triangles[1][1]);
  CHECK(volume(thicken_sheet(turned, 0.1)) == Approx(expected).epsilon(1e-12));
  CHECK(is_closed_and_outward(thicken_sheet(turned, 0.1)));

  TriangleMesh doubled = make_fold();
  for (const auto& [a, b, c] : make_fold().triangles) doubled.triangles.push_back({c, b, a});
  doubled.triangles.push_back(doubled.triangles[0]);
  CHECK(volume(thicken_sheet(doubled, 0.1)) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("where three sheets meet two go on and one ends") {
  // A floor of two squares with a wall on their common edge.
  TriangleMesh mesh = make_fold();
  mesh.vertices.emplace_back(-1, 0, 0);
  mesh.vertices.emplace_back(-1, 1, 0);
  mesh.triangles.push_back({6, 0, 1});
  mesh.triangles.push_back({6, 1, 7});
  const TriangleMesh solid = thicken_sheet(mesh, 0.1);
  CHECK(is_closed_and_outward(solid));
  CHECK(measure_statistics(solid).components == 2);
  CHECK(volume(solid) == Approx(0.4 + 0.2).epsilon(1e-12));
}

TEST_CASE("a Moebius strip becomes a closed solid") {
  TriangleMesh strip;
  const std::uint32_t steps = 60;
  for (std::uint32_t i = 0; i < steps; ++i) {
    const double u = 2 * std::numbers::pi * i / steps;
    for (const double v : {-0.3, 0.3}) {
      const double radius = 1 + v * std::cos(u / 2);
      strip.vertices.emplace_back(radius * std::cos(u), radius * std::sin(u), v * std::sin(u / 2));
    }
    const bool is_last = i + 1 == steps;
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = is_last ? 1 : a + 2;
    const std::uint32_t c = is_last ? 0 : a + 3;
    strip.triangles.push_back({a, b, c});
    strip.triangles.push_back({a, c, a + 1});
  }
  const TriangleMesh solid = thicken_sheet(strip, 0.05);
  CHECK(is_closed_and_outward(solid));
  CHECK(volume(solid) == Approx(2 * std::numbers::pi * 0.6 * 0.1).epsilon(0.05));
}

TEST_CASE("a sharp fold throws no spike") {
  TriangleMesh mesh = make_fold();
  for (int i : {4, 5}) mesh.vertices[i] = {1.0, mesh.vertices[i].y(), 0.01};
  const TriangleMesh solid = thicken_sheet(mesh, 0.1);
  for (const Eigen::Vector3d& vertex : solid.vertices) {
    CHECK(vertex.allFinite());
    CHECK(vertex.x() > -0.2 - 1e-12);
  }
}
