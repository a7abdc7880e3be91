#include "features/distance/planar_distance_field.h"

#include <array>
#include <cstdint>
#include <vector>

#include "features/distance/enclosing_ball.h"

namespace mdbd {
namespace {

// How far the walls reach above and below the plane, relative to R: what they leave open is seen
// from the plane under less than a hundredth of the full angle.
constexpr double wall_height = 10.0;

Eigen::Vector3d in_space(const Eigen::Vector2d& point, double z) {
  return {point.x(), point.y(), z};
}

Ball enclosing_disc(const PlanarDomain& domain) {
  std::vector<Eigen::Vector3d> points;
  for (const Outline& outline : domain) {
    for (const Eigen::Vector2d& point : outline) points.push_back(in_space(point, 0.0));
  }
  return enclosing_ball(points);
}

Eigen::Vector3d outline_centroid(const PlanarDomain& domain, const Eigen::Vector2d& origin) {
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  double length = 0.0;
  for (const Outline& outline : domain) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Eigen::Vector2d a = outline[i] - origin;
      const Eigen::Vector2d b = outline[(i + 1) % outline.size()] - origin;
      moment += 0.5 * (b - a).norm() * (a + b);
      length += (b - a).norm();
    }
  }
  return in_space(origin + moment / length, 0.0);
}

void add_wall(const Outline& outline, double height, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto corners = static_cast<std::uint32_t>(outline.size());
  for (const Eigen::Vector2d& point : outline) {
    mesh.vertices.push_back(in_space(point, -height));
    mesh.vertices.push_back(in_space(point, height));
  }
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t bottom = first + 2 * i;
    const std::uint32_t next = first + 2 * ((i + 1) % corners);
    mesh.triangles.push_back({bottom, next, next + 1});
    mesh.triangles.push_back({bottom, next + 1, bottom + 1});
  }
}

TriangleMesh build_walls(const PlanarDomain& domain, double height) {
  TriangleMesh mesh;
  for (const Outline& outline : domain) add_wall(outline, height, mesh);
  return mesh;
}

}  // namespace

PlanarDistanceField::PlanarDistanceField(const PlanarDomain& domain)
    : enclosing_ball_(enclosing_disc(domain)),
      centroid_(outline_centroid(domain, enclosing_ball_.center.head<2>())),
      walls_(build_walls(domain, wall_height * enclosing_ball_.radius), false) {}

void PlanarDistanceField::measure(std::span<const DistanceQuery> queries,
                                  std::span<DistanceSample> samples) const {
  walls_.measure(queries, samples);
  for (DistanceSample& sample : samples) sample.closest.z() = 0.0;
}

}  // namespace mdbd
