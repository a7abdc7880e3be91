#include "features/descriptor/solid_harmonics.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "features/descriptor/solid_frame.h"
#include "features/descriptor/spherical_harmonics.h"
#include "tests/support/ball_clouds.h"
#include "tests/support/sphere_points.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

double hat(double rho, int shell) {
  const double position = std::clamp((rho - 0.3) / 0.3, 0.0, solid_shells - 1.0);
  return std::max(0.0, 1 - std::abs(position - shell));
}

// By points of each ball: shells, directions and a Gauss rule along the radius of the ball.
std::vector<double> by_points(const std::vector<Ball>& balls, int points) {
  const SphericalHarmonics harmonics(solid_degree);
  const std::size_t count = harmonic_count(solid_degree);
  std::vector<std::vector<double>> sums(solid_shells, std::vector<double>(count, 0.0));
  std::vector<double> values(count);
  double volume = 0.0;
  const auto directions = sphere_quadrature(points);
  const auto radii = gauss_legendre(points);
  for (const Ball& ball : balls) {
    for (const auto& [x, x_weight] : radii) {
      const double s = ball.radius * (1 + x) / 2;
      for (const SpherePoint& direction : directions) {
        const Eigen::Vector3d point = ball.center + s * direction.direction;
        const double weight = direction.weight * s * s * x_weight * ball.radius / 2;
        harmonics.evaluate(direction_of(point), values);
        for (int shell = 0; shell < solid_shells; ++shell) {
          const double share = weight * hat(point.norm(), shell);
          for (std::size_t i = 0; i < count; ++i) sums[shell][i] += share * values[i];
        }
        volume += weight;
      }
    }
  }
  std::vector<double> amplitudes;
  for (const auto& sum : sums) append_amplitudes(sum, solid_degree, 1 / volume, amplitudes);
  return amplitudes;
}

}  // namespace

TEST_CASE("caps give what points in the balls give") {
  // The last ball holds the origin, the one before it touches it.
  const std::vector<Ball> balls{
      {{1.0, 0.2, 0}, 0.3}, {{-0.5, 1.3, 0.4}, 0.6}, {{0, 0, -0.9}, 0.4}, {{0, 0.1, -0.1}, 0.35}};
  const std::vector<double> found = solid_harmonics(balls);
  const std::vector<double> expected = by_points(balls, 60);
  REQUIRE(found.size() == solid_size);
  for (std::size_t i = 0; i < found.size(); ++i) {
    INFO(i);
    CHECK(std::abs(found[i] - expected[i]) < 3e-4);
  }
}

TEST_CASE("degree 0 holds the shares of the volume") {
  const std::vector<double> found = solid_harmonics(to_solid_frame(random_balls(100, 5)));
  double sum = 0.0;
  for (std::size_t i = 0; i < found.size(); i += solid_degree + 1) sum += found[i];
  CHECK(sum == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("a ball around the origin is round, and its shells have the volumes of spheres") {
  const double radius = std::sqrt(5.0 / 3);
  const std::vector<double> found = solid_harmonics(std::vector<Ball>{{{0, 0, 0}, radius}});
  for (int shell = 0; shell < solid_shells; ++shell) {
    for (int l = 1; l <= solid_degree; ++l) CHECK(found[shell * (solid_degree + 1) + l] == 0.0);
  }
  // All that is nearer than the first node counts there, between nodes it is shared.
  const auto integral = [](double rho) {
    return (0.6 * rho * rho * rho / 3 - std::pow(rho, 4) / 4) / 0.3;
  };
  const double expected =
      (std::pow(0.3, 3) / 3 + integral(0.6) - integral(0.3)) * 3 / std::pow(radius, 3);
  CHECK(found[0] == Approx(expected));
}

TEST_CASE("a ball that comes near the origin turns round continuously") {
  const auto at = [](double distance) {
    return solid_harmonics(std::vector<Ball>{{{0, distance, 0}, 0.9}, {{2, 0, 0}, 0.1}});
  };
  const std::vector<double> exact = at(0.0);
  for (const double distance : {1e-12, 1e-8, 1e-5}) {
    const std::vector<double> near = at(distance);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      CHECK(std::abs(exact[i] - near[i]) < 10 * distance + 1e-12);
    }
  }
}
