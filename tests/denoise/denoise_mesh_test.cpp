#include "features/denoise/denoise_mesh.h"

#include <cmath>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "perturbation/noise.h"
#include "perturbation/shuffling.h"
#include "tests/denoise/shapes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

using Distance = double (*)(const Eigen::Vector3d&);

double from_sphere(const Eigen::Vector3d& x) { return x.norm() - 1; }
double from_torus(const Eigen::Vector3d& x) {
  return std::hypot(std::hypot(x.x(), x.y()) - 1, x.z()) - 0.4;
}

struct Deviation {
  double root_mean_square = 0.0;
  double mean = 0.0;
};

Deviation deviation(const TriangleMesh& mesh, Distance distance) {
  Deviation result;
  const auto count = static_cast<double>(mesh.vertices.size());
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    result.mean += distance(vertex) / count;
    result.root_mean_square += std::pow(distance(vertex), 2) / count;
  }
  result.root_mean_square = std::sqrt(result.root_mean_square);
  return result;
}

void check_recovery(const TriangleMesh& clean, Distance distance, double bound) {
  const TriangleMesh noisy = displace_vertices(clean, bound, 11);
  const DenoisedMesh denoised = denoise_mesh(noisy);
  const Deviation before = deviation(noisy, distance);
  const Deviation after = deviation(denoised.mesh, distance);
  CHECK(denoised.noise > 0.0);
  CHECK(denoised.strength > 1.0);
  CHECK(after.root_mean_square < 0.35 * before.root_mean_square);
  CHECK(std::abs(after.mean) < 0.15 * before.root_mean_square);
  CHECK(denoised.mesh.triangles == clean.triangles);
}

double largest_distance(const TriangleMesh& left, const TriangleMesh& right) {
  double largest = 0.0;
  for (std::size_t i = 0; i < left.vertices.size(); ++i) {
    largest = std::max(largest, (left.vertices[i] - right.vertices[i]).norm());
  }
  return largest;
}

}  // namespace

TEST_CASE("a noisy surface comes back near the true one") {
  const double bound = GENERATE(0.005, 0.01, 0.02);
  INFO("noise " << bound);
  SECTION("sphere") { check_recovery(make_sphere(5), from_sphere, bound); }
  SECTION("torus") { check_recovery(make_torus(1, 0.4, 120, 50), from_torus, bound); }
}

TEST_CASE("clean shapes come back to the bit") {
  for (const NamedMesh& shape : clean_meshes()) {
    INFO(shape.name);
    const DenoisedMesh result = denoise_mesh(shape.mesh);
    CHECK(are_equal(result.mesh, shape.mesh));
    CHECK(result.noise == 0.0);
    CHECK(result.strength == 0.0);
  }
}

TEST_CASE("a copy in another pose or order is denoised alike") {
  const TriangleMesh noisy = displace_vertices(make_bumpy_sphere(5), 0.01, 3);
  const TriangleMesh expected = denoise_mesh(noisy).mesh;
  CHECK(largest_distance(expected, noisy) > 0.005);
  const auto check = [&](const auto& change) {
    CHECK(largest_distance(denoise_mesh(change(noisy)).mesh, change(expected)) < 1e-7);
  };
  check([](const TriangleMesh& mesh) { return shuffle(mesh, 5); });
  check([](const TriangleMesh& mesh) {
    const Eigen::AngleAxisd rotation(2.0, Eigen::Vector3d(1, 2, 3).normalized());
    TriangleMesh turned = mesh;
    for (auto& vertex : turned.vertices) vertex = 1e-3 * (rotation * vertex);
    return turned;
  });
  check([](const TriangleMesh& mesh) {
    TriangleMesh mirrored = mesh;
    for (auto& vertex : mirrored.vertices) vertex.x() = -vertex.x();
    return mirrored;
  });
}

TEST_CASE("the same mesh gives the same bits") {
  const TriangleMesh noisy = displace_vertices(make_torus(1, 0.4, 120, 50), 0.01, 3);
  CHECK(are_equal(denoise_mesh(noisy).mesh, denoise_mesh(noisy).mesh));
}

TEST_CASE("open, non-manifold and disconnected meshes are denoised, too") {
  TriangleMesh mesh = make_sheet(40);
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.vertices.emplace_back(mesh.vertices[i].x(), 20, mesh.vertices[i].y() - 20);
  }
  const auto joined = [&](std::uint32_t vertex) {  // the middle lines of both sheets are one
    return vertex >= 20 * 41 && vertex < 21 * 41 ? vertex : vertex + count;
  };
  for (const auto& [a, b, c] : make_sheet(40).triangles) {
    mesh.triangles.push_back({joined(a), joined(b), joined(c)});
  }
  mesh.vertices.emplace_back(60, 60, 60);  // no face has it
  const TriangleMesh noisy = displace_vertices(mesh, 0.005, 3);
  const DenoisedMesh denoised = denoise_mesh(noisy);
  CHECK(denoised.noise > 0.0);
  double before = 0.0;
  double after = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    before += std::pow(noisy.vertices[i].z(), 2);
    after += std::pow(denoised.mesh.vertices[i].z(), 2);
    CHECK(denoised.mesh.vertices[i].allFinite());
  }
  CHECK(std::sqrt(after) < 0.5 * std::sqrt(before));
  CHECK(denoised.mesh.vertices.back() == noisy.vertices.back());
}

TEST_CASE("a cloud of lone triangles comes back as it is") {
  TriangleMesh mesh;
  const TriangleMesh torus = displace_vertices(make_torus(1, 0.4, 60, 30), 0.02, 3);
  for (const Triangle& triangle : torus.triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const std::uint32_t corner : triangle) mesh.vertices.push_back(torus.vertices[corner]);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  CHECK(are_equal(denoise_mesh(mesh).mesh, mesh));
}
