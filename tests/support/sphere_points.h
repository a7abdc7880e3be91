#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace mdbd::test {

/// A direction with its share of the sphere's area 4 pi.
struct SpherePoint {
  Eigen::Vector3d direction;
  double weight = 0.0;
};

/// The points of the Gauss-Legendre quadrature on [-1, 1], by Newton's method, with their weights.
inline std::vector<std::pair<double, double>> gauss_legendre(int count) {
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    double slope = 1.0;
    for (int step = 0; step < 50; ++step) {
      double before = 1.0;
      double current = x;
      for (int l = 1; l < count; ++l) {
        before = std::exchange(current, ((2 * l + 1) * x * current - l * before) / (l + 1));
      }
      slope = count * (x * current - before) / (x * x - 1);
      x -= current / slope;
    }
    points.emplace_back(x, 2 / ((1 - x * x) * slope * slope));
  }
  return points;
}

/// Integrates polynomials up to a degree over the unit sphere exactly.
inline std::vector<SpherePoint> sphere_quadrature(int degree) {
  const int turns = degree + 1;
  std::vector<SpherePoint> points;
  for (const auto& [z, weight] : gauss_legendre(degree / 2 + 1)) {
    const double radius = std::sqrt(1 - z * z);
    for (int turn = 0; turn < turns; ++turn) {
      const double angle = 2 * std::numbers::pi * turn / turns;
      points.push_back({{radius * std::cos(angle), radius * std::sin(angle), z},
                        weight * 2 * std::numbers::pi / turns});
    }
  }
  return points;
}

}  // namespace mdbd::test
