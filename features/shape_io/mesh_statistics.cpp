#include "features/shape_io/mesh_statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "features/core/disjoint_sets.h"

namespace mdbd {
namespace {

// Relative to the volume's absolute terms: what rounding leaves of a surface that encloses nothing.
constexpr double negligible_volume = 1e-12;

/// One side of one triangle.
struct HalfEdge {
  std::uint32_t low;
  std::uint32_t high;
  bool is_forward;  // from low to high

  bool is_along(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i];
      const std::uint32_t to = triangle[(i + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  }
  std::ranges::sort(edges, {}, [](const HalfEdge& e) { return std::pair(e.low, e.high); });
  return edges;
}

/// Counts the edges; returns whether all neighbours at manifold edges agree in orientation.
bool count_edges(const TriangleMesh& mesh, MeshStatistics& statistics) {
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  bool neighbours_agree = true;
  statistics.watertight = !edges.empty();
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].is_along(edges[begin])) ++end;
    const std::size_t faces = end - begin;
    if (faces == 1) ++statistics.open_edges;
    if (faces >= 3) ++statistics.non_manifold_edges;
    if (faces % 2 == 1) statistics.watertight = false;
    if (faces == 2 && edges[begin].is_forward == edges[begin + 1].is_forward) {
      neighbours_agree = false;
    }
  }
  return neighbours_agree;
}

void count_components(const TriangleMesh& mesh, MeshStatistics& statistics) {
  DisjointSets sets(mesh.vertices.size());  // of vertices that faces join
  std::vector<char> is_used(mesh.vertices.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      is_used[corner] = 1;
      sets.join(triangle[0], corner);
    }
  }
  for (std::uint32_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i] == 0) continue;
    ++statistics.vertices;
    if (sets.root(i) == i) ++statistics.components;
  }
}

// Seen from the middle of the mesh, so that an open shell has the sign of the closed one and
// positions far from the origin lose nothing. All components together: a cavity turns inward.
bool encloses_negative_volume(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return false;
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) box.extend(mesh.vertices[corner]);
  }
  const Eigen::Vector3d middle = box.center();
  const double scale = box.sizes().maxCoeff();
  if (scale == 0.0) return false;

  double volume = 0.0;
  double absolute = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d p = (mesh.vertices[a] - middle) / scale;
    const Eigen::Vector3d q = (mesh.vertices[b] - middle) / scale;
    const Eigen::Vector3d r = (mesh.vertices[c] - middle) / scale;
    const double term = p.dot(q.cross(r));
    volume += term;
    absolute += std::abs(term);
  }
  return volume < -negligible_volume * absolute;
}

}  // namespace

std::string_view to_string(Orientation orientation) {
  switch (orientation) {
    case Orientation::outward:
      return "outward";
    case Orientation::inverted:
      return "inverted";
    case Orientation::mixed:
      return "mixed";
  }
  return "";
}

MeshStatistics measure_statistics(const TriangleMesh& mesh) {
  MeshStatistics statistics;
  statistics.faces = mesh.triangles.size();
  const bool neighbours_agree = count_edges(mesh, statistics);
  count_components(mesh, statistics);
  if (!neighbours_agree) {
    statistics.orientation = Orientation::mixed;
  } else if (encloses_negative_volume(mesh)) {
    statistics.orientation = Orientation::inverted;
  }
  return statistics;
}

std::string to_json(const MeshStatistics& statistics) {
  const nlohmann::ordered_json object = {
      {"vertices", statistics.vertices},
      {"faces", statistics.faces},
      {"watertight", statistics.watertight},
      {"open_edges", statistics.open_edges},
      {"non_manifold_edges", statistics.non_manifold_edges},
      {"components", statistics.components},
      {"orientation", to_string(statistics.orientation)},
      {"polygons_triangulated", statistics.polygons_triangulated},
      {"vertices_welded", statistics.vertices_welded},
      {"vertices_unused", statistics.vertices_unused},
      {"faces_degenerate", statistics.faces_degenerate},
      {"faces_invalid", statistics.faces_invalid},
  };
  return object.dump();
}

}  // namespace mdbd
