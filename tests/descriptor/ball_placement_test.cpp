#include "features/descriptor/ball_placement.h"

#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "features/descriptor/solid_frame.h"
#include "tests/support/ball_clouds.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

double legendre(int l, double x) {
  double before = 1.0;
  double current = x;
  if (l == 0) return 1.0;
  for (int i = 1; i < l; ++i) {
    before = std::exchange(current, ((2 * i + 1) * x * current - i * before) / (i + 1));
  }
  return current;
}

// The hat function of node i of an evenly spaced grid whose ends reach to infinity.
double hat(double position, int i, int count) {
  return std::max(0.0, 1 - std::abs(std::clamp(position, 0.0, count - 1.0) - i));
}

// The amplitude by the addition theorem: a sum over pairs of balls, without any harmonics.
double amplitude(const std::vector<Ball>& balls, int d, int r, int l) {
  double total = 0.0;
  for (const Ball& ball : balls) total += ball.radius * ball.radius;
  const auto weight = [&](const Ball& ball) {
    const double distance = ball.center.norm();
    const double in_distance = hat(distance / 0.5, d, placement_distances);
    const double in_radius = hat((std::log2(ball.radius) + 6) / 2, r, placement_radii);
    const double width = ball.radius / distance;
    return ball.radius * ball.radius / total * in_distance * in_radius *
           std::exp(-l * (l + 1) * width * width / 10);
  };
  double energy = 0.0;
  for (const Ball& a : balls) {
    for (const Ball& b : balls) {
      const double cosine = a.center.normalized().dot(b.center.normalized());
      energy += weight(a) * weight(b) * (2 * l + 1) * legendre(l, cosine);
    }
  }
  return std::sqrt(std::max(0.0, energy));
}

}  // namespace

TEST_CASE("the placement is what the addition theorem gives") {
  const std::vector<Ball> balls = to_solid_frame(random_balls(40, 7));
  const std::vector<double> found = ball_placement(balls);
  REQUIRE(found.size() == placement_size);
  std::size_t i = 0;
  for (int d = 0; d < placement_distances; ++d) {
    for (int r = 0; r < placement_radii; ++r) {
      for (int l = 0; l <= placement_degree; ++l) {
        CHECK(std::abs(found[i++] - amplitude(balls, d, r, l)) < 1e-9);
      }
    }
  }
}

TEST_CASE("degree 0 holds the shares of the weight") {
  const std::vector<double> found = ball_placement(to_solid_frame(random_balls(100, 2)));
  double sum = 0.0;
  for (std::size_t i = 0; i < found.size(); i += placement_degree + 1) sum += found[i];
  CHECK(sum == Approx(1.0));
}

TEST_CASE("a ball at the origin has no direction, and neither has one very near it") {
  const std::vector<double> at = ball_placement(std::vector<Ball>{{{0, 0, 0}, 1.0}});
  const std::vector<double> near = ball_placement(std::vector<Ball>{{{1e-9, -1e-9, 0}, 1.0}});
  CHECK(at[(placement_radii - 1) * (placement_degree + 1)] == Approx(1.0));
  CHECK(std::accumulate(at.begin(), at.end(), 0.0) == Approx(1.0));
  for (std::size_t i = 0; i < at.size(); ++i) CHECK(std::abs(at[i] - near[i]) < 1e-8);
}
