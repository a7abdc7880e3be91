#include "perturbation/surface_sampling.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "features/core/errors.h"
#include "features/core/random.h"
#include "features/distance/enclosing_ball.h"
#include "features/shape_io/content_hash.h"
#include "features/shape_io/read_mesh.h"
#include "perturbation/noise.h"
#include "perturbation/random_vectors.h"

namespace mdbd {
namespace {

/// areas[i] is twice the area of the triangles 0 … i.
std::vector<double> cumulative_areas(const TriangleMesh& mesh) {
  std::vector<double> areas;
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& corner = mesh.vertices[a];
    sum += (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner).norm();
    areas.push_back(sum);
  }
  if (!(sum > 0) || !std::isfinite(sum)) {
    throw InvalidInput("has no surface that points could be drawn from");
  }
  return areas;
}

}  // namespace

PointCloud sample_points(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed) {
  const std::vector<double> areas = cumulative_areas(mesh);
  Random random(seed);
  PointCloud cloud;
  cloud.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = std::ranges::upper_bound(areas, random.uniform() * areas.back());
    const auto index = std::min<std::ptrdiff_t>(found - areas.begin(), std::ssize(areas) - 1);
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(index)];
    const double root = std::sqrt(random.uniform());
    const double along = random.uniform();
    cloud.points.push_back((1 - root) * mesh.vertices[a] + root * (1 - along) * mesh.vertices[b] +
                           root * along * mesh.vertices[c]);
  }
  return cloud;
}

PointCloud displace_points(const PointCloud& cloud, double bound, std::uint64_t seed) {
  PointCloud noisy = cloud;
  noisy.points = displace_vertices({cloud.points, {}}, bound, seed).vertices;
  return noisy;
}

PointCloud rotate(const PointCloud& cloud, std::uint64_t seed) {
  Random random(seed);
  const Eigen::Matrix3d rotation = random_rotation(random).toRotationMatrix();
  const Eigen::Vector3d middle = enclosing_ball(cloud.points).center;
  PointCloud rotated = cloud;
  for (Eigen::Vector3d& point : rotated.points) point = middle + rotation * (point - middle);
  for (Eigen::Vector3d& normal : rotated.normals) normal = rotation * normal;
  return rotated;
}

PointCloud sample_file(const std::filesystem::path& path, const CloudSampling& sampling,
                       std::uint64_t seed) {
  const std::uint64_t own_seed = derive_seed(seed, content_hash(path));
  PointCloud cloud =
      sample_points(read_mesh(path).mesh, sampling.points, derive_seed(own_seed, "points"));
  if (sampling.noise > 0) {
    cloud = displace_points(cloud, sampling.noise / 100, derive_seed(own_seed, "noise"));
  }
  return rotate(cloud, derive_seed(own_seed, "rotation"));
}

}  // namespace mdbd
