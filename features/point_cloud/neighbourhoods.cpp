#include "features/point_cloud/neighbourhoods.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

namespace mdbd {
namespace {

// Within [-1, 1]^3, where single precision is at its best.
pcl::PointCloud<pcl::PointXYZ>::Ptr to_pcl(std::span<const Eigen::Vector3d> points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  const double half_size = box.sizes().maxCoeff() / 2;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3f local = ((point - box.center()) / half_size).cast<float>();
    cloud->emplace_back(local.x(), local.y(), local.z());
  }
  return cloud;
}

}  // namespace

Neighbourhoods::Neighbourhoods(std::span<const Eigen::Vector3d> points, std::size_t size)
    : size_(std::min(size, points.size() - 1)) {
  const auto cloud = to_pcl(points);
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  neighbours_.reserve(points.size() * size_);
  pcl::Indices found;
  std::vector<float> squared_distances;
  for (std::size_t i = 0; i < points.size(); ++i) {
    tree.nearestKSearch((*cloud)[i], static_cast<unsigned>(size_ + 1), found, squared_distances);
    // The point itself is first, unless rounding made it coincide with another.
    std::erase(found, static_cast<int>(i));
    for (std::size_t k = 0; k < size_; ++k) {
      neighbours_.push_back(static_cast<std::uint32_t>(found[k]));
    }
  }
}

}  // namespace mdbd
