#include "evaluation/rivals/surface_samples.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "features/core/errors.h"
#include "features/core/random.h"

namespace mdbd {
namespace {

using Vertices = std::vector<Eigen::Vector3d>;

/// The vertices, moved and scaled into [-1, 1]^3.
Vertices normalised(const Vertices& vertices) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : vertices) box.extend(vertex);
  const double half_size = box.sizes().maxCoeff() / 2;
  if (!(half_size > 0) || !std::isfinite(half_size)) {
    throw InvalidInput("has no surface that points could be drawn from");
  }
  Vertices result;
  for (const Eigen::Vector3d& vertex : vertices) {
    result.push_back((vertex - box.center()) / half_size);
  }
  return result;
}

/// areas[i] is twice the area of the triangles 0 … i.
std::vector<double> cumulative_areas(const TriangleMesh& mesh, const Vertices& vertices) {
  std::vector<double> areas;
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).norm();
    areas.push_back(sum);
  }
  if (!(sum > 0)) throw InvalidInput("has no surface that points could be drawn from");
  return areas;
}

}  // namespace

std::vector<Eigen::Vector3f> sample_surface(const TriangleMesh& mesh, std::size_t count,
                                            std::uint64_t seed) {
  const Vertices vertices = normalised(mesh.vertices);
  const std::vector<double> areas = cumulative_areas(mesh, vertices);
  Random random(seed);
  std::vector<Eigen::Vector3f> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = std::ranges::upper_bound(areas, random.uniform() * areas.back());
    const auto index = std::min<std::ptrdiff_t>(found - areas.begin(), std::ssize(areas) - 1);
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(index)];
    const double root = std::sqrt(random.uniform());
    const double along = random.uniform();
    const Eigen::Vector3d point =
        (1 - root) * vertices[a] + root * (1 - along) * vertices[b] + root * along * vertices[c];
    points.push_back(point.cast<float>());
  }
  return points;
}

}  // namespace mdbd
