#include "perturbation/surface_sampling.h"

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/distance/closest_point.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("points are drawn from the surface, as many from each part as its area says") {
  TriangleMesh box = make_cube();
  for (Eigen::Vector3d& vertex : box.vertices) vertex.x() *= 3;
  const std::size_t count = 20'000;
  const PointCloud cloud = sample_points(box, count, 1);
  REQUIRE(cloud.points.size() == count);
  CHECK(cloud.normals.empty());
  const TriangleTree tree(box);
  double ends = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : cloud.points) {
    CHECK(find_closest_point(tree, point).squared_distance < 1e-24);
    ends += point.x() < 1e-9 || point.x() > 3 - 1e-9 ? 1 : 0;
    mean += point / static_cast<double>(count);
  }
  CHECK(ends / count == Approx(2.0 / 14.0).epsilon(0.05));
  CHECK((mean - Eigen::Vector3d(1.5, 0.5, 0.5)).norm() < 0.03);
}

TEST_CASE("a seed gives the same cloud, another seed another") {
  const TriangleMesh torus = make_torus(1.0, 0.4, 12, 8);
  CHECK(sample_points(torus, 100, 1).points == sample_points(torus, 100, 1).points);
  CHECK(sample_points(torus, 100, 1).points != sample_points(torus, 100, 2).points);
}

TEST_CASE("noise and rotation of a cloud keep to their bounds") {
  PointCloud cloud = sample_points(make_sphere(1.0, 20), 500, 1);
  cloud.normals = cloud.points;
  const PointCloud noisy = displace_points(cloud, 0.01, 1);
  const PointCloud rotated = rotate(cloud, 1);
  double largest = 0.0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    largest = std::max(largest, (noisy.points[i] - cloud.points[i]).norm());
    const std::size_t j = (i + 1) % cloud.points.size();
    CHECK((rotated.points[i] - rotated.points[j]).norm() ==
          Approx((cloud.points[i] - cloud.points[j]).norm()));
    CHECK((rotated.normals[i] - rotated.normals[j]).norm() ==
          Approx((cloud.normals[i] - cloud.normals[j]).norm()));
  }
  CHECK(largest <= 0.0201);
  CHECK(largest > 0.015);
  CHECK(rotated.points != cloud.points);
}

TEST_CASE("the cloud of a file depends on its content and the seed alone") {
  const TemporaryDirectory directory;
  const std::string torus = to_off(make_torus(1.0, 0.4, 12, 8));
  const auto one = directory.write("one.off", torus);
  const auto two = directory.write("two.off", torus);
  const CloudSampling sampling{.points = 100, .noise = 0.5};
  CHECK(sample_file(one, sampling, 1).points == sample_file(two, sampling, 1).points);
  CHECK(sample_file(one, sampling, 1).points != sample_file(one, sampling, 2).points);
}

TEST_CASE("a mesh without area has no points") {
  TriangleMesh flat{.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, .triangles = {{0, 1, 2}}};
  CHECK_THROWS_AS(sample_points(flat, 10, 1), InvalidInput);
}
