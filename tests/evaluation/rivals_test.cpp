#include <cmath>
#include <functional>
#include <numeric>

#include <catch2/catch.hpp>

#include "evaluation/rivals/d2.h"
#include "evaluation/rivals/distance_harmonics.h"
#include "evaluation/rivals/esf.h"
#include "evaluation/rivals/gasd.h"
#include "evaluation/rivals/surface_samples.h"
#include "features/core/errors.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;

namespace {

/// The square [0, 1]^2 in the plane z = 0, one half of it in many slivers.
TriangleMesh make_square() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  std::uint32_t last = 2;
  for (int i = 1; i < 10; ++i) {
    mesh.vertices.emplace_back(1 - 0.1 * i, 1, 0);
    const auto next = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    mesh.triangles.push_back({0, last, next});
    last = next;
  }
  mesh.triangles.push_back({0, last, 3});
  return mesh;
}

TriangleMesh moved_and_scaled(TriangleMesh mesh) {
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex = 1024 * vertex + Eigen::Vector3d(65536, -131072, 0);
  }
  return mesh;
}

/// A sphere of small steps, nearly round.
TriangleMesh make_sphere(double radius) {
  constexpr std::uint32_t around = 96;
  constexpr std::uint32_t rings = 47;
  TriangleMesh mesh;
  for (std::uint32_t ring = 1; ring <= rings; ++ring) {
    const double polar = std::numbers::pi * ring / (rings + 1);
    for (std::uint32_t step = 0; step < around; ++step) {
      const double angle = 2 * std::numbers::pi * step / around;
      mesh.vertices.emplace_back(radius * std::sin(polar) * std::cos(angle),
                                 radius * std::sin(polar) * std::sin(angle),
                                 radius * std::cos(polar));
    }
  }
  const auto north = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0, 0, radius);
  mesh.vertices.emplace_back(0, 0, -radius);
  for (std::uint32_t step = 0; step < around; ++step) {
    const std::uint32_t next = (step + 1) % around;
    mesh.triangles.push_back({north, step, next});
    const std::uint32_t last = (rings - 1) * around;
    mesh.triangles.push_back({north + 1, last + next, last + step});
    for (std::uint32_t first = 0; first < last; first += around) {
      mesh.triangles.push_back({first + step, first + around + step, first + next});
      mesh.triangles.push_back({first + next, first + around + step, first + around + next});
    }
  }
  return mesh;
}

double l1(const std::vector<float>& a, const std::vector<float>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0, std::plus<>(),
                            [](float x, float y) { return std::abs(x - y); });
}

double sum(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

struct Rival {
  const char* name;
  std::function<std::vector<float>(const TriangleMesh&, std::uint64_t)> compute;
  std::size_t size;
  double total;
};

const std::vector<Rival> rivals = {{"D2", compute_d2, d2_bins, 1.0},
                                   {"ESF", compute_esf, esf_size, 1.0},
                                   {"GASD", compute_gasd, gasd_size, 100.0}};

}  // namespace

TEST_CASE("points are spread evenly over a surface, whatever its triangles") {
  constexpr std::size_t count = 40'000;
  const std::vector<Eigen::Vector3f> points = sample_surface(make_square(), count, 1);
  REQUIRE(points.size() == count);
  int counts[4][4] = {};
  for (const Eigen::Vector3f& point : points) {
    REQUIRE(point.cwiseAbs().maxCoeff() <= 1.0F);
    CHECK(point.z() == 0.0F);
    ++counts[std::min(3, static_cast<int>(2 * (point.x() + 1)))]
            [std::min(3, static_cast<int>(2 * (point.y() + 1)))];
  }
  for (const auto& row : counts) {
    for (const int cell : row) CHECK(std::abs(cell - 2500) < 250);  // five standard deviations
  }
}

TEST_CASE("points depend on the seed, not on place and size") {
  const TriangleMesh torus = test::make_torus(2, 0.5, 12, 8);
  CHECK(sample_surface(torus, 100, 1) == sample_surface(torus, 100, 1));
  CHECK(sample_surface(torus, 100, 1) != sample_surface(torus, 100, 2));
  const auto points = sample_surface(torus, 100, 1);
  const auto others = sample_surface(moved_and_scaled(torus), 100, 1);
  for (std::size_t i = 0; i < points.size(); ++i) CHECK((points[i] - others[i]).norm() < 1e-6);
}

TEST_CASE("no points are drawn from what has no area") {
  TriangleMesh mesh = make_square();
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.y() = 0;
  CHECK_THROWS_AS(sample_surface(mesh, 1, 1), InvalidInput);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.x() = 0;
  CHECK_THROWS_AS(sample_surface(mesh, 1, 1), InvalidInput);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.x() = 1.7e308 * (vertex.z() > 0 ? 1 : -1);
  CHECK_THROWS_AS(sample_surface(mesh, 1, 1), InvalidInput);
}

TEST_CASE("rivals are seeded, normalised, and independent of place and size") {
  const TriangleMesh torus = test::make_torus(2, 0.5, 24, 16);
  const TriangleMesh cube = test::make_cube();
  for (const Rival& rival : rivals) {
    INFO(rival.name);
    const std::vector<float> first = rival.compute(torus, 1);
    CHECK(first.size() == rival.size);
    CHECK(rival.compute(torus, 1) == first);
    CHECK(rival.compute(torus, 2) != first);
    CHECK(sum(first) == Approx(rival.total).epsilon(1e-3));
    const double to_itself = l1(first, rival.compute(moved_and_scaled(torus), 2));
    CHECK(to_itself < 0.2 * l1(first, rival.compute(cube, 1)));
  }
}

TEST_CASE("harmonics of distances of a ball are those of a function of the radius alone") {
  const std::vector<float> found = compute_distance_harmonics(make_sphere(3.0));
  REQUIRE(found.size() == distance_harmonics_size);
  for (int shell = 1; shell <= distance_shells; ++shell) {
    // The surface is at half the radius of the outermost sphere, the Gaussian 1/16 of it wide.
    const double radius = shell / 32.0;
    const double expected = radius * std::exp(-std::pow((radius - 0.5) * 16, 2));
    const std::size_t first = (shell - 1) * (distance_degree + 1);
    CHECK(std::abs(found[first] - expected) < 0.01);
    for (int l = 1; l <= distance_degree; ++l) CHECK(found[first + l] < 0.01);
  }
}

TEST_CASE("harmonics of distances do not depend on pose, place and size") {
  TriangleMesh mesh = test::make_torus(2, 0.5, 24, 16);
  const std::vector<float> expected = compute_distance_harmonics(mesh);
  const std::vector<float> cube = compute_distance_harmonics(test::make_cube());
  CHECK(l1(compute_distance_harmonics(moved_and_scaled(mesh)), expected) < 1e-3);
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex = {vertex.z(), 0.6 * vertex.x() - 0.8 * vertex.y(), 0.8 * vertex.x() + 0.6 * vertex.y()};
  CHECK(l1(compute_distance_harmonics(mesh), expected) < 0.1 * l1(cube, expected));
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = Eigen::Vector3d::Zero();
  CHECK_THROWS_AS(compute_distance_harmonics(mesh), InvalidInput);
}

TEST_CASE("D2 of a square is the known distribution") {
  // The density of the distance of two points of the unit square, for t <= 1:
  // 2 t (pi - 4 t + t^2); mean 0.521405.
  const std::vector<float> histogram = compute_d2(make_square(), 3);
  const auto cumulative = [](double t) {
    return std::numbers::pi * t * t - 8.0 / 3 * t * t * t + 0.5 * t * t * t * t;
  };
  const double width = d2_range * 0.5214054331 / d2_bins;
  for (std::size_t i = 0; (i + 1) * width < 1; ++i) {
    const double expected = cumulative((i + 1) * width) - cumulative(i * width);
    CHECK(std::abs(histogram[i] - expected) < 0.002);
  }
}
