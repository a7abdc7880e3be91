#include "features/solidify/enclosure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "features/distance/triangle_tree.h"
#include "features/distance/winding_number.h"

namespace mdbd {
namespace {

// A point is surely inside or outside if the winding number is so far from one half. Above its
// error of 0.1, and below what the rim of an open vessel has.
constexpr double margin = 0.25;
constexpr int samples = 1000;

struct SurfacePoint {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;  // unit vector
  std::uint32_t face;
};

// Points at equal steps of area, the same for the same mesh; where in the face a low-discrepancy
// sequence says (Roberts 2018, R2).
std::vector<SurfacePoint> spread_points(const TriangleMesh& mesh) {
  std::vector<double> area_up_to;
  double area = 0.0;
  const auto area_normal = [&](const Triangle& t) -> Eigen::Vector3d {
    return (mesh.vertices[t[1]] - mesh.vertices[t[0]])
        .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
  };
  for (const Triangle& triangle : mesh.triangles) {
    area_up_to.push_back(area += area_normal(triangle).norm());
  }
  std::vector<SurfacePoint> points;
  std::uint32_t face = 0;
  for (int i = 0; i < samples; ++i) {
    const double target = (i + 0.5) / samples * area;
    while (face + 1 < area_up_to.size() && area_up_to[face] < target) ++face;
    double u = std::fmod(0.5 + 0.7548776662466927 * i, 1.0);
    double v = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
    if (u + v > 1.0) std::tie(u, v) = std::pair(1.0 - u, 1.0 - v);
    const auto& [a, b, c] = mesh.triangles[face];
    points.push_back(
        {(1.0 - u - v) * mesh.vertices[a] + u * mesh.vertices[b] + v * mesh.vertices[c],
         area_normal(mesh.triangles[face]).normalized(), face});
  }
  return points;
}

bool is_bounding(const WindingNumber& winding_number, const Eigen::Vector3d& point,
                 const Eigen::Vector3d& step) {
  const auto [low, high] =
      std::minmax({winding_number(point + step), winding_number(point - step)});
  return low < 0.5 - margin && high > 0.5 + margin;
}

}  // namespace

Enclosure measure_enclosure(const TriangleMesh& mesh, double depth) {
  const TriangleTree tree(mesh);
  const WindingNumber winding_number(tree);
  Enclosure enclosure;
  for (const auto& [point, normal, face] : spread_points(mesh)) {
    enclosure.samples.push_back({face, is_bounding(winding_number, point, depth * normal)});
  }
  const auto bounding = std::ranges::count(enclosure.samples, true, &EnclosureSample::is_bounding);
  enclosure.share = static_cast<double>(bounding) / samples;
  return enclosure;
}

std::vector<double> share_of_parts(const Enclosure& enclosure,
                                   const std::vector<std::uint32_t>& part_of, std::uint32_t parts) {
  std::vector<int> all(parts, 0);
  std::vector<int> bounding(parts, 0);
  for (const auto& [face, is_bounding] : enclosure.samples) {
    ++all[part_of[face]];
    bounding[part_of[face]] += is_bounding ? 1 : 0;
  }
  std::vector<double> shares(parts, enclosure.share);
  for (std::uint32_t part = 0; part < parts; ++part) {
    if (all[part] > 0) shares[part] = static_cast<double>(bounding[part]) / all[part];
  }
  return shares;
}

}  // namespace mdbd
