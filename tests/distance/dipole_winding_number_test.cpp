#include "features/distance/dipole_winding_number.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

/// Points spread evenly over the unit sphere (Fibonacci's spiral).
std::vector<Eigen::Vector3d> even_sphere(int count) {
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double radius = std::sqrt(1 - z * z);
    points.emplace_back(radius * std::cos(turn * i), radius * std::sin(turn * i), z);
  }
  return points;
}

}  // namespace

TEST_CASE("the winding number of oriented points agrees with the sum of all dipoles") {
  const int count = 3000;
  const std::vector<Eigen::Vector3d> points = even_sphere(count);
  const PointTree tree(points);
  const double area = 4 * std::numbers::pi / count;
  std::vector<Eigen::Vector3d> area_vectors;
  for (const Eigen::Vector3d& point : tree.points()) area_vectors.push_back(area * point);
  const DipoleWindingNumber winding(tree, area_vectors);
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d place = random_point(random, 1.5);
    double sum = 0.0;
    for (std::size_t k = 0; k < area_vectors.size(); ++k) {
      const Eigen::Vector3d offset = tree.points()[k] - place;
      const double squared = offset.squaredNorm() + area;
      sum += area_vectors[k].dot(offset) / (4 * std::numbers::pi * squared * std::sqrt(squared));
    }
    INFO("place " << place.transpose());
    CHECK(winding(place) == Approx(sum).margin(0.03));
    if (std::abs(place.norm() - 1.0) > 3 * std::sqrt(area)) {
      CHECK(winding(place) == Approx(place.norm() < 1 ? 1.0 : 0.0).margin(0.06));
    }
  }
}
