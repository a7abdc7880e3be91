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

/// What was found at the points of one part.
struct PartCount {
  int all = 0;
  int bounding = 0;

  double share(double unknown) const {
    return all > 0 ? static_cast<double>(bounding) / all : unknown;
  }
};

struct SurfacePoint {
  Eigen::Vector3d point;
  Eigen::Vector3d normal;  // unit vector
  std::size_t face;
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
  std::size_t face = 0;
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

Enclosure measure_enclosure(const TriangleMesh& mesh, const std::vector<std::uint32_t>& part_of,
                            double depth) {
  const TriangleTree tree(mesh);
  const WindingNumber winding_number(tree);
  std::vector<PartCount> parts(1 + *std::ranges::max_element(part_of));
  PartCount whole;
  for (const auto& [point, normal, face] : spread_points(mesh)) {
    const int bounding = is_bounding(winding_number, point, depth * normal) ? 1 : 0;
    for (PartCount* count : {&whole, &parts[part_of[face]]}) {
      ++count->all;
      count->bounding += bounding;
    }
  }
  Enclosure enclosure{.share = whole.share(1.0), .part_shares = {}};
  for (const PartCount& part : parts) {
    enclosure.part_shares.push_back(part.share(enclosure.share));
  }
  return enclosure;
}

}  // namespace mdbd
