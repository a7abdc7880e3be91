#include "features/point_cloud/cloud_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace mdbd {
namespace {

Eigen::Vector3d plane_normal(const PointCloud& cloud, std::size_t point,
                             std::span<const std::uint32_t> neighbours) {
  const Eigen::Vector3d& origin = cloud.points[point];
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  const double size = (cloud.points[neighbours.back()] - origin).norm();
  for (const std::uint32_t neighbour : neighbours) {
    const Eigen::Vector3d offset = (cloud.points[neighbour] - origin) / size;
    mean += offset;
    moment += offset * offset.transpose();
  }
  const double count = static_cast<double>(neighbours.size()) + 1.0;
  const Eigen::Matrix3d covariance = moment / count - mean * mean.transpose() / (count * count);
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

CloudSurface estimate_surface(const PointCloud& cloud, const Neighbourhoods& neighbourhoods) {
  CloudSurface surface;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const std::span<const std::uint32_t> neighbours = neighbourhoods.of(i);
    const double squared_radius = (cloud.points[neighbours.back()] - cloud.points[i]).squaredNorm();
    surface.areas.push_back(std::numbers::pi * squared_radius /
                            static_cast<double>(neighbours.size()));
    surface.normals.push_back(plane_normal(cloud, i, neighbours));
  }
  surface.spacing = std::sqrt(median(surface.areas));
  return surface;
}

}  // namespace mdbd
