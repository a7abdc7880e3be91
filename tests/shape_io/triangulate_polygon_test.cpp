#include "features/shape_io/triangulate_polygon.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "features/core/errors.h"

namespace mdbd::test {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

// Somewhere in space, not along the axes.
std::vector<Eigen::Vector3d> place(const Polygon& polygon) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector2d& p : polygon) {
    vertices.emplace_back(rotation * Eigen::Vector3d(p.x(), p.y(), 0) + Eigen::Vector3d(5, -7, 2));
  }
  return vertices;
}

std::vector<Triangle> triangulate(const std::vector<Eigen::Vector3d>& vertices) {
  std::vector<std::uint32_t> corners(vertices.size());
  std::iota(corners.begin(), corners.end(), 0U);
  std::vector<Triangle> triangles;
  PolygonTriangulator().triangulate(vertices, corners, triangles);
  return triangles;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double area(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]) / 2;
  }
  return sum;
}

// The triangles of a simple polygon all turn as it does, and their areas add up to its own: then
// they cover it and do not overlap.
void check_covers(const Polygon& polygon) {
  for (const Polygon& side : {polygon, Polygon(polygon.rbegin(), polygon.rend())}) {
    const std::vector<Triangle> triangles = triangulate(place(side));
    REQUIRE(triangles.size() == side.size() - 2);
    double sum = 0.0;
    for (const auto& [a, b, c] : triangles) {
      const double part = cross(side[b] - side[a], side[c] - side[a]) / 2;
      CHECK(part * area(side) > 0);
      sum += part;
    }
    CHECK(sum == Approx(area(side)));
  }
}

}  // namespace

TEST_CASE("Convex polygons") {
  check_covers({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  Polygon circle;
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * std::numbers::pi * i / 100;
    circle.emplace_back(std::cos(angle), std::sin(angle));
  }
  check_covers(circle);
}

TEST_CASE("Concave polygons") {
  check_covers({{0, 0}, {4, 0}, {1, 1}, {0, 4}});  // an arrow head
  check_covers({{1, 1}, {0, 4}, {0, 0}, {4, 0}});  // begun elsewhere
  check_covers({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});  // a U
  Polygon comb = {{0, -1}, {40, -1}};
  for (int i = 40; i > 0; --i) {
    comb.emplace_back(i, 0);
    comb.emplace_back(i - 0.5, 5);
  }
  comb.emplace_back(0, 0);
  check_covers(comb);
}

TEST_CASE("Corners on a straight side get no flat triangle") {
  check_covers({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}});
  check_covers({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {1.5, 2}, {0, 2}, {0, 1}});
}

TEST_CASE("A hole joined to the rim by a slit") {
  check_covers({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
}

TEST_CASE("Random stars") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> radius(0.2, 1.0);
  for (int round = 0; round < 50; ++round) {
    Polygon star;
    const int corners = 4 + round;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const double r = radius(random);
      star.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    check_covers(star);
  }
}

TEST_CASE("Polygons that cross themselves or have no area still get their triangles") {
  CHECK(triangulate(place({{0, 0}, {1, 1}, {1, 0}, {0, 1}})).size() == 2);
  CHECK(triangulate(place({{0, 0}, {1, 0}, {2, 0}, {3, 0}})).size() == 2);
  CHECK(triangulate(place({{0, 0}, {3, 0}, {0, 1}, {3, 2}, {0, 3}, {3, 3}, {1, -1}})).size() == 5);
}

TEST_CASE("Large polygons") {
  const auto wave = [](int corners, double depth) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const double r = 1 - depth * (i % 2);
      polygon.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return polygon;
  };
  check_covers(wave(1000, 0.1));
  CHECK(triangulate(place(wave(20'000, 0.0))).size() == 19'998);
  CHECK_THROWS_AS(triangulate(place(wave(20'000, 0.5))), InvalidInput);
}

}  // namespace mdbd::test
