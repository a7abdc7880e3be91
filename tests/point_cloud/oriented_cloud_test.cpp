#include "features/point_cloud/oriented_cloud.h"

#include <random>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "perturbation/surface_sampling.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;
using Catch::Contains;

namespace {

/// The share of the points of a cloud around the origin whose normals point outward.
double outward_share(const OrientedCloud& cloud) {
  double count = 0.0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    count += cloud.area_vectors[i].dot(cloud.points[i]) > 0 ? 1 : 0;
  }
  return count / static_cast<double>(cloud.points.size());
}

PointCloud sphere_cloud(std::size_t count) { return sample_points(make_sphere(1.0, 40), count, 1); }

PointCloud with_normals(PointCloud cloud, double sign) {
  for (const Eigen::Vector3d& point : cloud.points) {
    cloud.normals.push_back(sign * point.normalized());
  }
  return cloud;
}

double total_area(const OrientedCloud& cloud) {
  double sum = 0.0;
  for (const Eigen::Vector3d& vector : cloud.area_vectors) sum += vector.norm();
  return sum;
}

}  // namespace

TEST_CASE("normals of a sphere's cloud are radial, and its areas make up the sphere's") {
  const OrientedCloud cloud = orient_cloud(sphere_cloud(4000));
  CHECK(cloud.orientation == "flood from outside");
  CHECK(outward_share(cloud) == 1.0);
  double worst = 1.0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    worst = std::min(worst, cloud.area_vectors[i].normalized().dot(cloud.points[i].normalized()));
  }
  CHECK(worst > 0.98);
  CHECK(total_area(cloud) == Approx(4 * M_PI).epsilon(0.05));
  CHECK(cloud.spacing == Approx(std::sqrt(4 * M_PI / 4000)).epsilon(0.1));
  CHECK(cloud.outliers == 0);
}

TEST_CASE("normals that are given are used, turned or passed over") {
  const PointCloud bare = sphere_cloud(2000);
  const OrientedCloud outward = orient_cloud(with_normals(bare, 1.0));
  CHECK(outward.orientation == "given normals");
  CHECK(outward_share(outward) == 1.0);
  const OrientedCloud inward = orient_cloud(with_normals(bare, -1.0));
  CHECK(inward.orientation == "given normals, turned");
  CHECK(outward_share(inward) == 1.0);
  PointCloud mixed = with_normals(bare, 1.0);
  for (std::size_t i = 0; i < mixed.normals.size(); i += 2) mixed.normals[i] *= -1;
  const OrientedCloud repaired = orient_cloud(mixed);
  CHECK(repaired.orientation == "flood from outside");
  CHECK(outward_share(repaired) == 1.0);
}

TEST_CASE("points far from all others are left out") {
  PointCloud cloud = sphere_cloud(3000);
  cloud.points.emplace_back(0, 0, 0.1);
  cloud.points.emplace_back(3, 0, 0);
  cloud.points.emplace_back(0, -0.4, 0);
  const OrientedCloud oriented = orient_cloud(cloud);
  CHECK(oriented.outliers == 3);
  CHECK(oriented.points.size() == 3000);
}

TEST_CASE("thin solids are oriented where the spacing resolves them") {
  TriangleMesh plate = make_cube();
  for (Eigen::Vector3d& vertex : plate.vertices) {
    vertex = {2 * vertex.x() - 1, 2 * vertex.y() - 1, 0.1 * (vertex.z() - 0.5)};
  }
  const OrientedCloud cloud = orient_cloud(sample_points(plate, 8000, 1));
  double wrong = 0.0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3d& point = cloud.points[i];
    const bool is_on_a_side = std::max(std::abs(point.x()), std::abs(point.y())) < 0.9;
    wrong += is_on_a_side && cloud.area_vectors[i].z() * point.z() < 0 ? 1 : 0;
  }
  CHECK(wrong == 0);
}

TEST_CASE("open clouds are refused with the reason") {
  PointCloud open;
  std::mt19937 random(1);
  SECTION("a square") {
    for (int i = 0; i < 2000; ++i) {
      open.points.push_back(random_point(random, 1.0).cwiseProduct(Eigen::Vector3d(1, 1, 0)));
    }
  }
  SECTION("a shallow bowl") {
    for (const Eigen::Vector3d& point : sphere_cloud(8000).points) {
      if (point.z() < -0.7) open.points.push_back(point);
    }
  }
  SECTION("a line") {
    for (int i = 0; i < 200; ++i) open.points.emplace_back(0.01 * i, 0, 0);
  }
  CHECK_THROWS_WITH(orient_cloud(open), Contains("an open cloud"));
  CHECK_THROWS_AS(orient_cloud(open), InvalidInput);
}

TEST_CASE("too few points are refused with their number") {
  CHECK_THROWS_WITH(orient_cloud(sphere_cloud(10)), Contains("too few points: 10"));
}

TEST_CASE("orientation depends neither on position nor on scale") {
  const PointCloud cloud = sphere_cloud(1000);
  for (const double scale : {1e-20, 1e20}) {
    PointCloud moved = cloud;
    for (Eigen::Vector3d& point : moved.points) {
      point = scale * (point + Eigen::Vector3d(0, 10, 0));
    }
    OrientedCloud oriented = orient_cloud(moved);
    for (Eigen::Vector3d& point : oriented.points) {
      point -= scale * Eigen::Vector3d(0, 10, 0);
    }
    CHECK(outward_share(oriented) == 1.0);
    CHECK(oriented.spacing == Approx(scale * orient_cloud(cloud).spacing).epsilon(1e-3));
  }
}
