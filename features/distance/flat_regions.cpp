#include "features/distance/flat_regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "features/core/box.h"
#include "features/distance/closest_point.h"

namespace mdbd {
namespace {

constexpr double flatness = 1e-12;  // relative to the size of the mesh

/// A side of a triangle, which runs from one corner to another.
struct Side {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t triangle;
};

/// The sides of all triangles, those between the same two vertices one after another.
std::vector<Side> grouped_sides(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> begin(mesh.vertices.size() + 2, 0);
  const auto for_each_side = [&](const auto& visit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = mesh.triangles[t];
      for (int i = 0; i < 3; ++i) visit(Side{corners[i], corners[(i + 1) % 3], t});
    }
  };
  for_each_side([&](const Side& side) { ++begin[std::min(side.from, side.to) + 2]; });
  for (std::size_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<Side> sides(3 * mesh.triangles.size());
  for_each_side([&](const Side& side) { sides[begin[std::min(side.from, side.to) + 1]++] = side; });
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1],
              [](const Side& a, const Side& b) {
                return std::pair(std::max(a.from, a.to), a.triangle) <
                       std::pair(std::max(b.from, b.to), b.triangle);
              });
  }
  return sides;
}

bool are_between_same_vertices(const Side& a, const Side& b) {
  return std::minmax(a.from, a.to) == std::minmax(b.from, b.to);
}

/// A normal, with twice the area as length.
Eigen::Vector3d normal_of(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
}

class Joiner {
 public:
  explicit Joiner(const TriangleMesh& mesh)
      : mesh_(mesh), is_joined_(mesh.triangles.size()), parent_(mesh.triangles.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    Box box;
    for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
    tolerance_ = flatness * box.sizes().norm();
  }

  void run() {
    const std::vector<Side> sides = grouped_sides(mesh_);
    std::vector<Side> creases;
    for (std::size_t begin = 0; begin < sides.size();) {
      std::size_t end = begin + 1;
      while (end < sides.size() && are_between_same_vertices(sides[begin], sides[end])) ++end;
      if (!join(std::span(sides).subspan(begin, end - begin))) {
        creases.insert(creases.end(), sides.begin() + begin, sides.begin() + end);
      }
      begin = end;
    }
    for (const Side& crease : creases) {
      if (is_joined_[crease.triangle]) outlines_.push_back(crease);
    }
  }

  bool is_joined(std::uint32_t triangle) const { return is_joined_[triangle]; }

  /// The triangle that stands for a triangle's region.
  std::uint32_t root(std::uint32_t triangle) {
    while (parent_[triangle] != triangle) {
      triangle = parent_[triangle] = parent_[parent_[triangle]];
    }
    return triangle;
  }

  /// The outlines of the regions as triangles without area.
  TriangleMesh outlines() const {
    TriangleMesh mesh{.vertices = mesh_.vertices, .triangles = {}};
    for (const Side& side : outlines_) mesh.triangles.push_back({side.from, side.to, side.to});
    return mesh;
  }

 private:
  const Eigen::Vector3d& vertex(std::uint32_t index) const { return mesh_.vertices[index]; }

  Eigen::Vector3d unit_normal(std::uint32_t triangle) const {
    return normal_of(mesh_, triangle).normalized();
  }

  // Whether the sides are those of two triangles in one plane; these are joined then.
  bool join(std::span<const Side> sides) {
    if (sides.size() != 2 || sides[0].from != sides[1].to) return false;
    if (!is_flat(sides[0].triangle, sides[1].triangle)) return false;
    is_joined_[sides[0].triangle] = is_joined_[sides[1].triangle] = true;
    parent_[root(sides[1].triangle)] = root(sides[0].triangle);
    return true;
  }

  bool is_flat(std::uint32_t left, std::uint32_t right) const {
    return unit_normal(left).dot(unit_normal(right)) > 0.5 && is_in_plane(left, right) &&
           is_in_plane(right, left);
  }

  bool is_in_plane(std::uint32_t triangle, std::uint32_t of) const {
    const Eigen::Vector3d normal = unit_normal(of);
    const Eigen::Vector3d& origin = vertex(mesh_.triangles[of][0]);
    return std::ranges::all_of(mesh_.triangles[triangle], [&](std::uint32_t corner) {
      return std::abs(normal.dot(vertex(corner) - origin)) <= tolerance_;
    });
  }

  const TriangleMesh& mesh_;
  double tolerance_ = 0.0;
  std::vector<bool> is_joined_;
  std::vector<std::uint32_t> parent_;  // of each triangle, up to the root of its region
  std::vector<Side> outlines_;
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
    const Eigen::Vector3d normal = normal_of(mesh, t);
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
