#include "features/denoise/vertex_neighbours.h"

#include <algorithm>
#include <numeric>

namespace mdbd {
namespace {

/// For each vertex the two other corners of each of its faces, as VertexNeighbours lays them out.
VertexNeighbours list_corners(const TriangleMesh& mesh) {
  VertexNeighbours lists;
  lists.begin.assign(mesh.vertices.size() + 1, 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) lists.begin[corner + 1] += 2;
  }
  std::partial_sum(lists.begin.begin(), lists.begin.end(), lists.begin.begin());
  lists.vertices.resize(lists.begin.back());
  std::vector<std::uint32_t> next(lists.begin.begin(), lists.begin.end() - 1);
  for (const Triangle& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t corner = triangle[i];
      lists.vertices[next[corner]++] = triangle[(i + 1) % 3];
      lists.vertices[next[corner]++] = triangle[(i + 2) % 3];
    }
  }
  return lists;
}

}  // namespace

VertexNeighbours find_neighbours(const TriangleMesh& mesh) {
  VertexNeighbours result = list_corners(mesh);
  result.is_open.resize(result.vertices.size());
  std::uint32_t kept = 0;
  std::uint32_t first = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const std::uint32_t last = result.begin[v + 1];
    std::sort(result.vertices.begin() + first, result.vertices.begin() + last);
    result.begin[v] = kept;
    for (std::uint32_t end = first; first < last; first = end) {
      const std::uint32_t neighbour = result.vertices[first];
      while (end < last && result.vertices[end] == neighbour) ++end;
      result.vertices[kept] = neighbour;
      result.is_open[kept++] = end - first == 1 ? 1 : 0;
    }
  }
  result.begin.back() = kept;
  result.vertices.resize(kept);
  result.is_open.resize(kept);
  return result;
}

}  // namespace mdbd
