#include "features/denoise/noise_estimate.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "features/distance/enclosing_ball.h"
#include "perturbation/noise.h"
#include "perturbation/shuffling.h"
#include "perturbation/similarity_transform.h"
#include "tests/denoise/shapes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

/// With the level relative to R.
NoiseEstimate estimate(const TriangleMesh& mesh) {
  const double scale = enclosing_ball(mesh.vertices).radius;
  NoiseEstimate result = estimate_noise(mesh, find_neighbours(mesh), scale);
  result.level /= scale;
  return result;
}

/// The deviation of one coordinate of a vector uniform in a ball of that share of the diameter.
double level_of(double bound) { return 2 * bound / std::sqrt(5.0); }

}  // namespace

TEST_CASE("the level of noise is found within a quarter") {
  for (const NamedMesh& shape : fine_meshes()) {
    for (const double bound : {0.003, 0.005, 0.01, 0.02}) {
      INFO(shape.name << " with noise " << bound);
      const NoiseEstimate found = estimate(displace_vertices(shape.mesh, bound, 3));
      CHECK(found.is_significant);
      CHECK(found.level == Approx(level_of(bound)).epsilon(0.25));
    }
  }
}

TEST_CASE("clean shapes have no noise") {
  for (const NamedMesh& shape : clean_meshes()) {
    INFO(shape.name);
    CHECK_FALSE(estimate(shape.mesh).is_significant);
  }
}

TEST_CASE("noise that does not matter is left alone") {
  for (const NamedMesh& shape : fine_meshes()) {
    INFO(shape.name);
    CHECK_FALSE(estimate(displace_vertices(shape.mesh, 0.0005, 3)).is_significant);
  }
}

TEST_CASE("noise on a part of the surface is shape") {
  TriangleMesh mesh = make_sphere(5);
  const TriangleMesh noisy = displace_vertices(mesh, 0.01, 3);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (mesh.vertices[i].z() > 0.2) mesh.vertices[i] = noisy.vertices[i];
  }
  CHECK_FALSE(estimate(mesh).is_significant);
}

TEST_CASE("the estimate does not depend on order, pose and scale") {
  const TriangleMesh noisy = displace_vertices(make_bumpy_sphere(5), 0.01, 3);
  const NoiseEstimate expected = estimate(noisy);
  for (const TriangleMesh& copy : {shuffle(noisy, 5), rotate(noisy, 6), mirror(noisy, 7),
                                   translate(noisy, 3.0, 8), scale(noisy, 1e-4)}) {
    const NoiseEstimate found = estimate(copy);
    CHECK(found.is_significant);
    CHECK(found.level == Approx(expected.level).epsilon(1e-9));
    CHECK(found.evenness == Approx(expected.evenness).epsilon(1e-9));
    CHECK(found.same_side == Approx(expected.same_side).margin(1e-3));
    CHECK(found.flatness == Approx(expected.flatness).margin(1e-3));
  }
}

TEST_CASE("hostile meshes have an estimate") {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  CHECK_FALSE(estimate(mesh).is_significant);

  TriangleMesh crushed = displace_vertices(make_sphere(4), 0.02, 3);
  for (auto& vertex : crushed.vertices) vertex.y() = vertex.z() = 0;  // all on a line
  CHECK_FALSE(estimate(crushed).is_significant);

  CHECK_FALSE(estimate(make_prism(5000, 1)).is_significant);  // hubs of 5000 faces
  const TriangleMesh noisy = displace_vertices(make_sphere(4), 0.02, 3);
  for (const double size : {1e-250, 1e150, 1e250}) {
    TriangleMesh sized = noisy;
    for (auto& vertex : sized.vertices) vertex *= size;
    CHECK_NOTHROW(estimate(sized));
  }
}
