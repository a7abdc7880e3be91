#include "evaluation/rivals/gasd.h"

#include <pcl/features/gasd.h>
#include <pcl/features/impl/gasd.hpp>  // the one template, not the 42 MB of PCL's library of them
#include <pcl/point_types.h>

#include "evaluation/rivals/surface_samples.h"

namespace mdbd {

static_assert(pcl::GASDSignature512::descriptorSize() == gasd_size);

std::vector<float> compute_gasd(const TriangleMesh& mesh, std::uint64_t seed) {
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& point : sample_surface(mesh, gasd_points, seed)) {
    cloud->emplace_back(point.x(), point.y(), point.z());
  }
  pcl::GASDEstimation<pcl::PointXYZ> estimation;
  estimation.setShapeHistsInterpMethod(pcl::INTERP_NONE);
  estimation.setInputCloud(cloud);
  pcl::PointCloud<pcl::GASDSignature512> signature;
  estimation.compute(signature);
  const float* values = signature.front().histogram;
  return {values, values + gasd_size};
}

}  // namespace mdbd
