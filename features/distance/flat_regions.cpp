#include "features/distance/flat_regions.h"

#include <cmath>
#include <span>

#include "features/core/disjoint_sets.h"
#include "features/distance/closest_point.h"
#include "features/distance/coplanar_triangles.h"

namespace mdbd {
namespace {

class Joiner {
 public:
  explicit Joiner(const TriangleMesh& mesh)
      : mesh_(mesh),
        coplanarity_(mesh),
        is_joined_(mesh.triangles.size()),
        regions_(mesh.triangles.size()) {}

  void run() {
    const std::vector<TriangleSide> sides = grouped_sides(mesh_);
    std::vector<TriangleSide> creases;
    for_each_edge(sides, [&](std::span<const TriangleSide> edge) {
      if (!join(edge)) creases.insert(creases.end(), edge.begin(), edge.end());
    });
    for (const TriangleSide& crease : creases) {
      if (is_joined_[crease.triangle]) outlines_.push_back(crease);
    }
  }

  bool is_joined(std::uint32_t triangle) const { return is_joined_[triangle]; }

  /// The triangle that stands for a triangle's region.
  std::uint32_t root(std::uint32_t triangle) { return regions_.root(triangle); }

  /// The outlines of the regions as triangles without area.
  TriangleMesh outlines() const {
    TriangleMesh mesh{.vertices = mesh_.vertices, .triangles = {}};
    for (const TriangleSide& side : outlines_)
      mesh.triangles.push_back({side.from, side.to, side.to});
    return mesh;
  }

 private:
  // Whether the sides are those of two triangles in one plane; these are joined then.
  bool join(std::span<const TriangleSide> sides) {
    if (sides.size() != 2 || sides[0].from != sides[1].to) return false;
    const std::uint32_t left = sides[0].triangle;
    const std::uint32_t right = sides[1].triangle;
    if (!coplanarity_.is_in_plane(left, right) || !coplanarity_.is_in_plane(right, left)) {
      return false;
    }
    is_joined_[left] = is_joined_[right] = true;
    regions_.join(left, right);
    return true;
  }

  const TriangleMesh& mesh_;
  CoplanarityTest coplanarity_;
  std::vector<bool> is_joined_;
  DisjointSets regions_;  // of triangles
  std::vector<TriangleSide> outlines_;
};

}  // namespace

FlatRegions::FlatRegions(const TriangleMesh& mesh) {
  Joiner joiner(mesh);
  joiner.run();
  const TriangleMesh outlines = joiner.outlines();
  if (outlines.triangles.empty()) return;
  creases_.emplace(outlines);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  region_of_.assign(count, none);
  for (std::uint32_t t = 0; t < count; ++t) {
    if (!joiner.is_joined(t)) continue;
    std::uint32_t& number = region_of_[joiner.root(t)];
    if (number == none) {
      number = static_cast<std::uint32_t>(normals_.size());
      normals_.push_back(Eigen::Vector3d::Zero());
    }
    region_of_[t] = number;
    const Eigen::Vector3d normal = area_normal(mesh, t);
    if (normal.squaredNorm() > normals_[number].squaredNorm()) normals_[number] = normal;
  }
  for (Eigen::Vector3d& normal : normals_) normal.normalize();
}

FlatRegion FlatRegions::around(const Eigen::Vector3d& point, std::uint32_t triangle) const {
  if (region_of_.empty() || region_of_[triangle] == none) return {};
  const std::uint32_t region = region_of_[triangle];
  return {region, std::sqrt(find_closest_point(*creases_, point).squared_distance),
          normals_[region]};
}

}  // namespace mdbd
