#include "features/distance/point_tree.h"

#include <random>
#include <vector>

#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

std::vector<Eigen::Vector3d> random_points(std::size_t count, double size,
                                           const Eigen::Vector3d& middle, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.emplace_back(middle +
                        Eigen::Vector3d(uniform(random), uniform(random), uniform(random)));
  }
  return points;
}

double nearest_distance(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : points) nearest = std::min(nearest, (point - place).norm());
  return nearest;
}

}  // namespace

TEST_CASE("the closest of points is that of all points") {
  for (const std::size_t count : {1, 2, 8, 9, 64, 65, 1000, 5000}) {
    for (const double size : {1e-20, 1.0, 1e20}) {
      const Eigen::Vector3d middle = Eigen::Vector3d(3, -5, 100) * size;
      const auto points = random_points(count, size, middle, 1);
      const PointTree tree(points);
      for (const Eigen::Vector3d& place : random_points(50, 3 * size, middle, 2)) {
        const double expected = nearest_distance(points, place);
        INFO(count << " points, size " << size);
        CHECK((tree.points()[tree.find_closest(place)] - place).norm() == expected);
        CHECK((tree.points()[tree.find_closest(place, expected)] - place).norm() == expected);
      }
    }
  }
}

TEST_CASE("a tree holds every point once, with its number") {
  auto points = random_points(500, 1.0, Eigen::Vector3d::Zero(), 3);
  points.insert(points.end(), 100, Eigen::Vector3d::Ones());  // coinciding points are no problem
  const PointTree tree(points);
  std::vector<int> seen(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(tree.points()[i] == points[tree.sources()[i]]);
    ++seen[tree.sources()[i]];
  }
  CHECK(seen == std::vector<int>(points.size(), 1));
}
