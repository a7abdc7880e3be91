#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// The vertices that share an edge with a vertex, for all vertices of a mesh; the mesh need not be
/// a manifold.
struct VertexNeighbours {
  std::vector<std::uint32_t> begin;     ///< vertex v has the entries begin[v] … begin[v + 1] - 1
  std::vector<std::uint32_t> vertices;  ///< increasing and different for each vertex
  std::vector<char> is_open;            ///< whether the edge to that neighbour has a single face

  std::size_t size() const { return begin.size() - 1; }

  std::span<const std::uint32_t> of(std::uint32_t vertex) const {
    return {vertices.data() + begin[vertex], vertices.data() + begin[vertex + 1]};
  }

  std::span<const char> openness_of(std::uint32_t vertex) const {
    return {is_open.data() + begin[vertex], is_open.data() + begin[vertex + 1]};
  }
};

/// Time and memory are linear in the size of the mesh.
VertexNeighbours find_neighbours(const TriangleMesh& mesh);

}  // namespace mdbd
