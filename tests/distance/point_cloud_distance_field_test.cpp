#include "features/distance/point_cloud_distance_field.h"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "perturbation/surface_sampling.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

/// The share of random places, away from the surface by more than `margin`, whose side is wrong.
template <typename Contains>
double share_of_wrong_sides(const PointCloudDistanceField& field, double reach, double margin,
                            Contains contains) {
  std::mt19937 random(7);
  int wrong = 0;
  int asked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d place = random_point(random, reach);
    const DistanceSample sample = field.measure({place});
    if (std::abs(sample.distance) < margin) continue;
    ++asked;
    wrong += (sample.distance > 0) != contains(place);
  }
  REQUIRE(asked > 500);
  return static_cast<double>(wrong) / asked;
}

bool torus_contains(const Eigen::Vector3d& x) {
  return std::hypot(std::hypot(x.x(), x.y()) - 1.0, x.z()) < 0.4;
}

}  // namespace

TEST_CASE("distances are to the points, and the witness is one of them") {
  const PointCloud cloud = sample_points(make_torus(1.0, 0.4, 60, 30), 3000, 1);
  const PointCloudDistanceField field(orient_cloud(cloud));
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d place = random_point(random, 2.0);
    double nearest = 1e9;
    for (const Eigen::Vector3d& point : cloud.points) {
      nearest = std::min(nearest, (point - place).norm());
    }
    const DistanceSample sample = field.measure({place});
    CHECK(std::abs(sample.distance) == nearest);
    CHECK((sample.closest - place).norm() == nearest);
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : cloud.points) mean += point / 3000.0;
  CHECK((field.centroid() - mean).norm() < 1e-12);
  CHECK_FALSE(field.is_closed());
}

TEST_CASE("a cloud tells inside from outside") {
  const TriangleMesh torus = make_torus(1.0, 0.4, 120, 60);
  PointCloud cloud = sample_points(torus, 5000, 1);
  SECTION("uniform") {}
  SECTION("with noise") { cloud = displace_points(cloud, 0.005, 2); }
  SECTION("ten times as dense on one half") {
    const PointCloud dense = sample_points(torus, 50000, 3);
    for (const Eigen::Vector3d& point : dense.points) {
      if (point.x() > 0) cloud.points.push_back(point);
    }
  }
  SECTION("with outliers") {
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) cloud.points.push_back(random_point(random, 1.5));
  }
  SECTION("with a hole as wide as half the tube") {
    std::erase_if(cloud.points, [](const Eigen::Vector3d& point) {
      return (point - Eigen::Vector3d(1.4, 0, 0)).norm() < 0.2;
    });
  }
  const PointCloudDistanceField field(orient_cloud(cloud));
  CHECK(share_of_wrong_sides(field, 1.6, 0.08, torus_contains) <= 0.002);
}

TEST_CASE("a cavity is not filled") {
  PointCloud cloud = sample_points(make_sphere(1.0, 30), 6000, 1);
  const PointCloud cavity = sample_points(make_sphere(0.5, 20), 1500, 2);
  cloud.points.insert(cloud.points.end(), cavity.points.begin(), cavity.points.end());
  const PointCloudDistanceField field(orient_cloud(cloud));
  CHECK(field.measure({{0.75, 0, 0}}).distance == Approx(0.25).margin(0.02));
  CHECK(field.measure({{0, 0, -0.75}}).distance > 0);
  CHECK(field.measure({{0, 0, 0}}).distance < 0);
  CHECK(field.measure({{0.2, 0.1, 0}}).distance < 0);
  CHECK(field.measure({{0, 1.2, 0}}).distance < 0);
}
