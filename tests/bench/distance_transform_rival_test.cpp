#include "bench/rival/distance_transform_rival.h"

#include <catch2/catch.hpp>

#include "bench/ball_quality.h"
#include "bench/generated_shapes.h"
#include "features/decomposition/decompose.h"
#include "features/distance/mesh_distance_field.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;

namespace {

bench::RivalDecomposition decompose_with_rival(const TriangleMesh& mesh, int balls) {
  const MeshDistanceField field(mesh, true);
  return bench::decompose_by_distance_transform(mesh, field, {.resolution = 64, .balls = balls});
}

}  // namespace

TEST_CASE("the rival's balls are contained and disjoint") {
  const TriangleMesh mesh =
      GENERATE(bench::make_ring(2'000), bench::make_pipe(800), bench::make_bracket());
  const MeshDistanceField field(mesh, true);
  const bench::RivalDecomposition result = decompose_with_rival(mesh, 150);
  REQUIRE(result.balls.size() == 150);
  const bench::BallQuality quality = bench::measure_quality(field, result.balls, result.balls);
  CHECK(quality.escape <= 1e-12);
  CHECK(quality.overlap <= 1e-12);
}

TEST_CASE("the rival finds the balls of a cube nearly") {
  const bench::RivalDecomposition result = decompose_with_rival(test::make_cube(), 9);
  REQUIRE(result.balls.size() == 9);
  CHECK(result.balls[0].radius == Approx(0.5).epsilon(1e-3));
  for (std::size_t i = 1; i < 9; ++i) {
    CHECK(result.balls[i].radius == Approx(0.133975).epsilon(1e-3));
  }
}

TEST_CASE("the rival is close to the certified decomposition, and no more") {
  const TriangleMesh mesh = bench::make_ring(2'000);
  const MeshDistanceField field(mesh, true);
  const BallDecomposition certified = decompose(field, {.balls = 100});
  const bench::RivalDecomposition result = decompose_with_rival(mesh, 100);
  const bench::BallQuality quality = bench::measure_quality(field, result.balls, certified.balls);
  CHECK(quality.radius_error < 0.1);
  CHECK(quality.radius_error > 0.0);
}
