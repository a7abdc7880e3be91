#include "evaluation/rivals/esf.h"

#include <cstdint>

#include <pcl/common/distances.h>
#include <pcl/common/transforms.h>
#include <pcl/features/esf.h>
#include <pcl/point_types.h>

#include "evaluation/rivals/surface_samples.h"
#include "features/core/random.h"

// PCL's template calls rand() and srand() without a namespace, and its own namespace is searched
// before the global one: what stands here, before the template, is what it finds.
namespace pcl {
namespace {

mdbd::Random esf_random(0);

void srand(unsigned) {}  // with the time of day

int rand() { return static_cast<int>(esf_random.index(std::size_t{1} << 31)); }

}  // namespace
}  // namespace pcl

#include <pcl/features/impl/esf.hpp>

namespace mdbd {
namespace {

/// A type of its own, so that this program's instance of the template is not mistaken for the one
/// in PCL's library, which has the clock in it.
struct SeededSignature : pcl::ESFSignature640 {};

static_assert(pcl::ESFSignature640::descriptorSize() == esf_size);

}  // namespace

std::vector<float> compute_esf(const TriangleMesh& mesh, std::uint64_t seed) {
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& point : sample_surface(mesh, esf_points, seed)) {
    cloud->emplace_back(point.x(), point.y(), point.z());
  }
  pcl::esf_random = Random(derive_seed(seed, "esf"));
  pcl::ESFEstimation<pcl::PointXYZ, SeededSignature> estimation;
  estimation.setInputCloud(cloud);
  pcl::PointCloud<SeededSignature> signature;
  estimation.compute(signature);
  const float* values = signature.front().histogram;
  return {values, values + esf_size};
}

}  // namespace mdbd
