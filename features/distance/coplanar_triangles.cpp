#include "features/distance/coplanar_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "features/core/box.h"

namespace mdbd {

// Counted by their lower vertex first, which is faster than sorting all.
std::vector<TriangleSide> grouped_sides(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> begin(mesh.vertices.size() + 2, 0);
  const auto for_each_side = [&](const auto& visit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = mesh.triangles[t];
      for (int i = 0; i < 3; ++i) visit(TriangleSide{corners[i], corners[(i + 1) % 3], t});
    }
  };
  for_each_side([&](const TriangleSide& side) { ++begin[std::min(side.from, side.to) + 2]; });
  for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<TriangleSide> sides(3 * mesh.triangles.size());
  for_each_side(
      [&](const TriangleSide& side) { sides[begin[std::min(side.from, side.to) + 1]++] = side; });
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1],
              [](const TriangleSide& a, const TriangleSide& b) {
                return std::pair(std::max(a.from, a.to), a.triangle) <
                       std::pair(std::max(b.from, b.to), b.triangle);
              });
  }
  return sides;
}

CoplanarityTest::CoplanarityTest(const TriangleMesh& mesh) : mesh_(mesh) {
  Box box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  tolerance_ = flatness * box.sizes().norm();
}

Eigen::Vector3d CoplanarityTest::unit_normal(std::uint32_t triangle) const {
  return area_normal(mesh_, triangle).normalized();
}

bool CoplanarityTest::is_in_plane(std::uint32_t triangle, std::uint32_t of) const {
  const Eigen::Vector3d normal = unit_normal(of);
  if (!(normal.dot(unit_normal(triangle)) > 0.5)) return false;
  const Eigen::Vector3d& origin = mesh_.vertices[mesh_.triangles[of][0]];
  return std::ranges::all_of(mesh_.triangles[triangle], [&](std::uint32_t corner) {
    return std::abs(normal.dot(mesh_.vertices[corner] - origin)) <= tolerance_;
  });
}

Eigen::Vector3d area_normal(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
}

}  // namespace mdbd
