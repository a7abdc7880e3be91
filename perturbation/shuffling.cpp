#include "perturbation/shuffling.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "features/core/random.h"

namespace mdbd {
namespace {

// std::shuffle draws in a way that the standard leaves open.
template <typename Item>
void permute(std::vector<Item>& items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.index(i)]);
}

}  // namespace

TriangleMesh shuffle(const TriangleMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint32_t> places(mesh.vertices.size());
  std::iota(places.begin(), places.end(), 0U);
  permute(places, random);

  TriangleMesh shuffled = mesh;
  for (std::size_t i = 0; i < places.size(); ++i) shuffled.vertices[places[i]] = mesh.vertices[i];
  for (Triangle& triangle : shuffled.triangles) {
    for (std::uint32_t& corner : triangle) corner = places[corner];
    std::rotate(triangle.begin(), triangle.begin() + random.index(3), triangle.end());
  }
  permute(shuffled.triangles, random);
  return shuffled;
}

}  // namespace mdbd
