#include "perturbation/subdivision.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "features/core/errors.h"

namespace mdbd {
namespace {

constexpr std::size_t most_triangles = 50'000'000;

/// Appends the midpoints of edges to the vertices of a mesh, each once.
class Midpoints {
 public:
  explicit Midpoints(TriangleMesh& mesh) : mesh_(mesh) {}

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const std::uint64_t edge = std::uint64_t{low} << 32 | high;
    const auto [found, is_new] =
        indices_.try_emplace(edge, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) mesh_.vertices.emplace_back((mesh_.vertices[low] + mesh_.vertices[high]) / 2);
    return found->second;
  }

 private:
  TriangleMesh& mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> indices_;
};

}  // namespace

TriangleMesh subdivide(const TriangleMesh& mesh) {
  if (mesh.triangles.size() > most_triangles / 4) {
    throw InvalidInput(
        "too large to be subdivided: more than 50 million triangles would come of it");
  }
  TriangleMesh fine{.vertices = mesh.vertices, .triangles = {}};
  fine.triangles.reserve(4 * mesh.triangles.size());
  Midpoints midpoints(fine);
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = midpoints.between(a, b);
    const std::uint32_t bc = midpoints.between(b, c);
    const std::uint32_t ca = midpoints.between(c, a);
    fine.triangles.insert(fine.triangles.end(),
                          {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

}  // namespace mdbd
