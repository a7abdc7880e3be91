#include "features/point_cloud/outside_flood.h"

#include <catch2/catch.hpp>

#include "perturbation/surface_sampling.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("the flood surrounds a closed cloud and stays out of it") {
  const PointCloud cloud = sample_points(make_sphere(1.0, 30), 3000, 1);
  const OutsideFlood flood(cloud.points, std::vector<double>(3000, 0.15));
  CHECK_FALSE(flood.reaches({0, 0, 0}));
  CHECK_FALSE(flood.reaches({0, 0.7, 0}));
  CHECK_FALSE(flood.reaches({1.0, 0, 0}));
  CHECK(flood.reaches({1.3, 0, 0}));
  CHECK(flood.reaches({0, 0, -1.3}));
  CHECK(flood.reaches({100, 0, 0}));
}

TEST_CASE("the flood passes holes that are wider than its distance from the points alone") {
  PointCloud cloud = sample_points(make_sphere(1.0, 30), 3000, 1);
  std::erase_if(cloud.points, [](const Eigen::Vector3d& point) { return point.z() > 0.9; });
  const std::size_t count = cloud.points.size();
  CHECK(OutsideFlood(cloud.points, std::vector<double>(count, 0.15)).reaches({0, 0, 0}));
  CHECK_FALSE(OutsideFlood(cloud.points, std::vector<double>(count, 0.6)).reaches({0, 0, 0}));
}
