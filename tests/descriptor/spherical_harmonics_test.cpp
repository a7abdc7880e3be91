#include "features/descriptor/spherical_harmonics.h"

#include <numbers>

#include <catch2/catch.hpp>

#include "tests/support/sphere_points.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("the first harmonics are the ones of the textbook") {
  const Eigen::Vector3d u = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
  std::vector<double> values(harmonic_count(2));
  SphericalHarmonics(2).evaluate(u, values);
  const double first = std::sqrt(3 / (4 * std::numbers::pi));
  const double second = 0.5 * std::sqrt(15 / std::numbers::pi);
  CHECK(values[0] == Approx(0.5 / std::sqrt(std::numbers::pi)));
  CHECK(values[1] == Approx(first * u.y()));
  CHECK(values[2] == Approx(first * u.z()));
  CHECK(values[3] == Approx(first * u.x()));
  CHECK(values[4] == Approx(second * u.x() * u.y()));
  CHECK(values[6] == Approx(second / std::sqrt(12) * (3 * u.z() * u.z() - 1)));
  CHECK(values[8] == Approx(second / 2 * (u.x() * u.x() - u.y() * u.y())));
}

TEST_CASE("the harmonics are orthonormal") {
  constexpr int degree = 6;
  const SphericalHarmonics harmonics(degree);
  constexpr std::size_t count = harmonic_count(degree);
  std::vector<double> products(count * count, 0.0);
  std::vector<double> values(count);
  for (const SpherePoint& point : sphere_quadrature(2 * degree)) {
    harmonics.evaluate(point.direction, values);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        products[i * count + j] += point.weight * values[i] * values[j];
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      CHECK(std::abs(products[i * count + j] - (i == j ? 1.0 : 0.0)) < 1e-12);
    }
  }
}

TEST_CASE("in each degree the squares add up to (2l + 1) / (4 pi), in every direction") {
  const SphericalHarmonics harmonics(5);
  std::vector<double> values(harmonic_count(5));
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(1, 0, 0),
        Eigen::Vector3d(0.48, 0.6, 0.64)}) {
    harmonics.evaluate(direction, values);
    std::vector<double> amplitudes;
    append_amplitudes(values, 5, 1.0, amplitudes);
    for (int l = 0; l <= 5; ++l) CHECK(amplitudes[l] == Approx(std::sqrt(2 * l + 1)));
  }
}
