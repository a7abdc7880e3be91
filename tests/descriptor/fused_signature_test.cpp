#include "features/descriptor/fused_signature.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "features/decomposition/decompose.h"
#include "features/descriptor/solid_frame.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/ball_clouds.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

double distance(const std::vector<float>& f, const std::vector<float>& g) {
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += std::abs(double{f[i]} - double{g[i]});
  return sum;
}

std::span<const float> part(const std::vector<float>& signature, std::string_view name) {
  const auto found = std::ranges::find(fused_parts, name, &SignaturePart::name);
  return std::span(signature).subspan(found->first, found->count);
}

}  // namespace

TEST_CASE("the parts follow each other without gaps") {
  std::size_t next = 0;
  for (const SignaturePart& one : fused_parts) {
    CHECK(one.first == next);
    next += one.count;
  }
  CHECK(next == fused_size);
  CHECK(compute_fused_signature(random_balls(10, 1)).size() == fused_size);
}

TEST_CASE("mdbd-fused is invariant to rotation, reflection, translation and scale") {
  const std::vector<Ball> balls = random_balls(200, 1);
  const std::vector<float> expected = compute_fused_signature(balls);
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(0, 0) = -1;
  for (const Eigen::Matrix3d& turn :
       {some_rotation(), mirror, Eigen::Matrix3d(some_rotation() * mirror)}) {
    for (const double scale : {1.0, 25.4, 1e-7}) {
      const std::vector<float> found = compute_fused_signature(
          moved_balls(balls, turn, scale, scale * Eigen::Vector3d(10, -20, 5)));
      CHECK(distance(found, expected) < 1e-5);
      for (std::size_t i = 0; i < fused_size; ++i) CHECK(std::abs(found[i] - expected[i]) < 1e-6);
    }
  }
}

TEST_CASE("mdbd-fused of a symmetric shape is as invariant, although amplitudes vanish") {
  const BallDecomposition cube = decompose(BoxField({0.5, 0.5, 0.5}), {.balls = 40});
  const std::vector<float> expected = compute_fused_signature(cube.balls);
  const std::vector<float> found =
      compute_fused_signature(moved_balls(cube.balls, some_rotation(), 1.0, {1, 2, 3}));
  CHECK(distance(found, expected) < 1e-5);
}

TEST_CASE("the order of the balls is irrelevant") {
  std::vector<Ball> balls = random_balls(60, 2);
  const std::vector<float> expected = compute_fused_signature(balls);
  std::ranges::reverse(balls);
  CHECK(distance(compute_fused_signature(balls), expected) < 1e-6);
}

TEST_CASE("mdbd-fused changes little when balls change little") {
  const std::vector<Ball> balls = random_balls(100, 3);
  const std::vector<float> expected = compute_fused_signature(balls);
  double before = 0.0;
  for (const double change : {1e-6, 1e-4, 1e-2}) {
    std::vector<Ball> changed = balls;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      changed[i].center += change * Eigen::Vector3d(std::sin(i), std::cos(3 * i), std::sin(7 * i));
      changed[i].radius *= 1 + change * std::cos(5 * i);
    }
    const double moved = distance(compute_fused_signature(changed), expected);
    CHECK(moved < 30 * change + 1e-6);
    CHECK(moved > before);
    before = moved;
  }
}

TEST_CASE("a ball that shrinks to nothing leaves nothing behind") {
  std::vector<Ball> balls = random_balls(50, 6);
  const std::vector<float> expected = compute_fused_signature(balls);
  balls.push_back({{0.1, 5.0, 0.2}, 1e-6});
  CHECK(distance(compute_fused_signature(balls), expected) < 1e-3);
}

TEST_CASE("each number is the softened root of its part, times the weight") {
  const std::vector<Ball> balls = random_balls(80, 4);
  const std::vector<float> found = compute_fused_signature(balls);
  const std::vector<Ball> solid = to_solid_frame(balls);
  const auto check = [&](std::size_t part, std::span<const double> values) {
    REQUIRE(fused_parts[part].count == values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double root = std::sqrt(values[i] + 0.001) - std::sqrt(0.001);
      CHECK(found[fused_parts[part].first + i] ==
            Approx(fused_parts[part].weight * root).margin(1e-7));
    }
  };
  check(0, solid_harmonics(solid));
  const auto surroundings = ball_surroundings(solid);
  for (std::size_t kind = 0; kind < surroundings.size(); ++kind)
    check(1 + kind, surroundings[kind]);
}

TEST_CASE("one ball, two balls and none have a signature") {
  const std::vector<float> one = compute_fused_signature(std::vector<Ball>{{{4, 5, 6}, 2.0}});
  const double whole = std::sqrt(1.001) - std::sqrt(0.001);
  CHECK(part(one, "near")[surroundings_size - surroundings_nodes] == Approx(0.084 * whole));
  for (const float value :
       compute_fused_signature(std::vector<Ball>{{{0, 0, 0}, 1.0}, {{2, 0, 0}, 1.0}})) {
    CHECK(std::isfinite(value));
  }
  const std::vector<float> none = compute_fused_signature({});
  CHECK(std::ranges::count(none, 0.0F) == static_cast<std::ptrdiff_t>(fused_size));
}

TEST_CASE("all numbers are finite where balls share their centre with the solid") {
  const std::vector<Ball> balls{{{0, 0, 0}, 1.0}, {{1.5, 0, 0}, 0.5}, {{-1.5, 0, 0}, 0.5}};
  for (const float value : compute_fused_signature(balls)) CHECK(std::isfinite(value));
}
