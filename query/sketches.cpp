#include "query/sketches.h"

#include <utility>
#include <vector>

namespace mdbd {
namespace {

// Sketches of more numbers rule out more vectors and take longer to compare: measured by
// bench/search_benchmark.cpp.
constexpr std::size_t euclidean_size = 8;
constexpr std::size_t l1_size = 64;

}  // namespace

Sketches make_sketches(const VectorTable& collection, std::span<const MetricBlock> blocks) {
  const bool is_l1 = blocks.front().norm == PointNorm::l1;
  MetricSketch map(collection, blocks, is_l1 ? l1_size : euclidean_size);
  std::vector<float> points(collection.size() * map.size());
  for (std::size_t row = 0; row < collection.size(); ++row) {
    map.write(collection.values(row), std::span(points).subspan(row * map.size(), map.size()));
  }
  SketchList list(points, map.size(), map.norm());
  return {std::move(map), std::move(list)};
}

}  // namespace mdbd
