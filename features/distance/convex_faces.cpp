#include "features/distance/convex_faces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include <Eigen/Geometry>

#include "features/core/disjoint_sets.h"
#include "features/distance/coplanar_triangles.h"

namespace mdbd {
namespace {

/// An edge between two triangles in one plane.
struct FlatEdge {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t left;   // its side runs from `from` to `to`
  std::uint32_t right;  // its side runs back
  double squared_length;
};

class Joiner {
 public:
  explicit Joiner(const TriangleMesh& mesh)
      : mesh_(mesh), coplanarity_(mesh), faces_(mesh.triangles.size()) {}

  void run() {
    const std::vector<FlatEdge> edges = find_flat_edges();
    if (edges.empty()) return;
    polygons_.resize(mesh_.triangles.size());
    for (const FlatEdge& edge : edges) join(edge);
  }

  bool has_joined() const { return !polygons_.empty(); }
  std::uint32_t root(std::uint32_t triangle) { return faces_.root(triangle); }
  const std::vector<std::uint32_t>& polygon(std::uint32_t root) const { return polygons_[root]; }

 private:
  const Eigen::Vector3d& vertex(std::uint32_t index) const { return mesh_.vertices[index]; }

  // The longest first: they are the diagonals.
  std::vector<FlatEdge> find_flat_edges() const {
    const std::vector<TriangleSide> sides = grouped_sides(mesh_);
    std::vector<FlatEdge> edges;
    for_each_edge(sides, [&](std::span<const TriangleSide> edge) {
      if (edge.size() != 2 || edge[0].from != edge[1].to) return;
      const auto& [from, to, left] = edge[0];
      const std::uint32_t right = edge[1].triangle;
      if (!coplanarity_.is_in_plane(right, left)) return;
      edges.push_back({from, to, left, right, (vertex(from) - vertex(to)).squaredNorm()});
    });
    std::ranges::stable_sort(edges, std::greater<>(), &FlatEdge::squared_length);
    return edges;
  }

  std::vector<std::uint32_t>& polygon_of(std::uint32_t root) {
    std::vector<std::uint32_t>& polygon = polygons_[root];
    if (polygon.empty()) {
      polygon.assign(mesh_.triangles[root].begin(), mesh_.triangles[root].end());
    }
    return polygon;
  }

  void join(const FlatEdge& edge) {
    const std::uint32_t left = root(edge.left);
    const std::uint32_t right = root(edge.right);
    if (left == right) return;
    std::vector<std::uint32_t> joined = polygon_of(left);
    std::vector<std::uint32_t> other = polygon_of(right);
    if (joined.size() + other.size() - 2 > ConvexFaces::max_corners) return;
    // `to` first in one, `from` first in the other: the edge closes both.
    if (!rotate_to_edge(joined, edge.to, edge.from)) return;
    if (!rotate_to_edge(other, edge.from, edge.to)) return;
    joined.insert(joined.end(), other.begin() + 1, other.end() - 1);
    if (!is_convex(joined, coplanarity_.unit_normal(edge.left))) return;
    polygons_[left] = std::move(joined);
    polygons_[right].clear();
    faces_.join(left, right);
  }

  // Begins a polygon with `first`, so that it ends with `last`; false if they are no neighbours.
  static bool rotate_to_edge(std::vector<std::uint32_t>& polygon, std::uint32_t first,
                             std::uint32_t last) {
    std::rotate(polygon.begin(), std::ranges::find(polygon, first), polygon.end());
    return polygon.front() == first && polygon.back() == last;
  }

  bool is_convex(const std::vector<std::uint32_t>& polygon, const Eigen::Vector3d& normal) const {
    constexpr double flatness = CoplanarityTest::flatness;
    const std::size_t size = polygon.size();
    for (std::size_t i = 0; i < size; ++i) {
      const Eigen::Vector3d& a = vertex(polygon[i]);
      const Eigen::Vector3d before = vertex(polygon[(i + 1) % size]) - a;
      const Eigen::Vector3d after =
          vertex(polygon[(i + 2) % size]) - vertex(polygon[(i + 1) % size]);
      if (normal.dot(before.cross(after)) < -flatness * before.norm() * after.norm()) return false;
      if (before.dot(after) < 0 &&
          before.cross(after).norm() <= flatness * before.norm() * after.norm()) {
        return false;  // it turns back on itself
      }
      if (std::abs(normal.dot(a - vertex(polygon[0]))) > coplanarity_.tolerance()) return false;
    }
    return true;
  }

  const TriangleMesh& mesh_;
  CoplanarityTest coplanarity_;
  DisjointSets faces_;                                // of triangles
  std::vector<std::vector<std::uint32_t>> polygons_;  // at their roots; empty for lone triangles
};

}  // namespace

ConvexFaces::ConvexFaces(const TriangleMesh& mesh) {
  Joiner joiner(mesh);
  joiner.run();
  if (!joiner.has_joined()) return;
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::vector<std::uint32_t> face_of_root(count, none);
  face_of_.assign(count, none);
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::uint32_t root = joiner.root(t);
    const std::vector<std::uint32_t>& polygon = joiner.polygon(root);
    if (polygon.size() <= 3) continue;
    if (face_of_root[root] == none) {
      face_of_root[root] = static_cast<std::uint32_t>(begin_.size());
      begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
      for (const std::uint32_t corner : polygon) corners_.push_back(mesh.vertices[corner]);
    }
    face_of_[t] = face_of_root[root];
  }
  begin_.push_back(static_cast<std::uint32_t>(corners_.size()));
}

ConvexPolygon ConvexFaces::face_of(std::uint32_t triangle) const {
  if (face_of_.empty() || face_of_[triangle] == none) return {};
  const std::uint32_t face = face_of_[triangle];
  return ConvexPolygon(corners_).subspan(begin_[face], begin_[face + 1] - begin_[face]);
}

}  // namespace mdbd
