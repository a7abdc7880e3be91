#include "evaluation/certificate/recheck.h"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/sample_meshes.h"

using namespace mdbd;

namespace {

const double cube_scale = std::sqrt(3.0) / 2;
const double corner_radius = (std::sqrt(3.0) - 1) / (2 * (std::sqrt(3.0) + 1));

/// The first nine balls of the unit cube: the largest one and one in each corner.
std::vector<Ball> cube_balls() {
  std::vector<Ball> balls{{{0.5, 0.5, 0.5}, 0.5}};
  for (const Eigen::Vector3d& corner : test::make_cube().vertices) {
    const Eigen::Vector3d inward = Eigen::Vector3d::Constant(0.5) - corner;
    balls.push_back({corner + 2 * corner_radius * inward, corner_radius});
  }
  return balls;
}

RecheckedBalls recheck(const std::vector<Ball>& balls, double minimum_radius = 0.0,
                       const TriangleMesh& mesh = test::make_cube()) {
  return recheck_balls(mesh, balls, cube_scale, minimum_radius, {});
}

}  // namespace

TEST_CASE("the balls of a cube are contained, disjoint and maximal") {
  const RecheckedBalls result = recheck(cube_balls());
  CHECK(result.escape.size < 1e-15);
  CHECK(result.overlap.size < 1e-15);
  CHECK(result.excess.size < 1e-9);
  CHECK(result.search_reach >= 8.0 / 9);
}

TEST_CASE("a ball that leaves the solid is found with the right size") {
  std::vector<Ball> balls = cube_balls();
  balls[3].center.x() += balls[3].center.x() > 0.5 ? 1e-7 : -1e-7;
  RecheckedBalls result = recheck(balls);
  CHECK(result.escape.size == Approx(1e-7 / cube_scale).epsilon(1e-6));
  CHECK(result.escape.ball == 3);

  balls = cube_balls();
  balls[5].center = {2.0, 0.5, 0.5};  // outside: its depth is -1
  result = recheck(balls);
  CHECK(result.escape.size == Approx((1.0 + corner_radius) / cube_scale));
  CHECK(result.escape.ball == 5);
}

TEST_CASE("balls that overlap are found with the right size") {
  std::vector<Ball> balls = cube_balls();
  balls[7].center += 1e-7 * (balls[0].center - balls[7].center).normalized();
  const RecheckedBalls result = recheck(balls);
  CHECK(result.overlap.size == Approx(1e-7 / cube_scale).epsilon(1e-6));
  CHECK(result.overlap.ball == 7);
  CHECK(result.escape.size < 1e-15);
}

TEST_CASE("a ball that is too small is found") {
  std::vector<Ball> balls = cube_balls();
  balls[8].radius *= 0.9;
  const RecheckedBalls result = recheck(balls);
  CHECK(result.excess.size == Approx(1 / 0.9 - 1).epsilon(1e-3));
  CHECK(result.excess.ball == 8);
}

TEST_CASE("a ball that was left out is found where smaller ones follow") {
  std::vector<Ball> balls = cube_balls();
  balls.erase(balls.begin() + 4);
  balls.push_back({{0.5, 0.14, 0.02}, 0.0933});  // somewhere, and smaller than the corners' balls
  const RecheckedBalls result = recheck(balls);
  CHECK(result.excess.size == Approx(corner_radius / 0.0933 - 1).epsilon(1e-3));
  CHECK(result.excess.ball == 8);
}

TEST_CASE("balls in the wrong order are found") {
  std::vector<Ball> balls = cube_balls();
  std::swap(balls[0], balls[1]);
  const RecheckedBalls result = recheck(balls);
  CHECK(result.excess.size == Approx(0.5 / corner_radius - 1).epsilon(1e-3));
  CHECK(result.excess.ball == 0);
}

TEST_CASE("balls are missing at the end if larger ones than the smallest allowed fit") {
  const double next = 0.09335;  // the tenth radius of the cube
  const RecheckedBalls missing = recheck(cube_balls(), 0.05);
  CHECK(missing.excess.size == Approx(next / (0.05 * cube_scale) - 1).epsilon(1e-2));
  CHECK(missing.excess.ball == 9);
  CHECK(recheck(cube_balls(), 0.12).excess.size < 1e-9);
}

TEST_CASE("larger balls outside do not count, and a hole does not let the search out") {
  TriangleMesh mesh = test::make_cube();
  mesh.triangles.pop_back();
  const RecheckedBalls result = recheck(cube_balls(), 0.0, mesh);
  CHECK(result.escape.size < 1e-15);
  CHECK(result.excess.size < 0.2);  // the hole lets balls grow a little, not out
}

TEST_CASE("a re-check repeats itself and depends on its seed") {
  std::vector<Ball> balls = cube_balls();
  balls[0].radius = 0.45;  // leaves room for larger balls in the corners
  RecheckOptions options;
  const auto excess = [&] {
    return recheck_balls(test::make_cube(), balls, cube_scale, 0.0, options).excess.size;
  };
  const double first = excess();
  CHECK(excess() == first);
  options.seed = 2;
  CHECK(excess() != first);
  CHECK(excess() == Approx(first).epsilon(1e-2));
}
