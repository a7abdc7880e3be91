#include "query/metric_block.h"

#include <array>
#include <cmath>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

constexpr std::size_t lanes = 8;

float sum_of(const float* values) {
  float sum = 0.0F;
  for (std::size_t lane = 0; lane < lanes; ++lane) sum += values[lane];
  return sum;
}

MDBD_VECTORISED
float squared_l2(const float* f, const float* g, std::size_t count) {
  alignas(32) float sums[lanes] = {};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    MDBD_LANES
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const float difference = f[i + lane] - g[i + lane];
      sums[lane] += difference * difference;
    }
  }
  for (; i < count; ++i) sums[0] += (f[i] - g[i]) * (f[i] - g[i]);
  return sum_of(sums);
}

MDBD_VECTORISED
float l1(const float* f, const float* g, std::size_t count) {
  alignas(32) float sums[lanes] = {};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    MDBD_LANES
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      sums[lane] += std::abs(f[i + lane] - g[i + lane]);
    }
  }
  for (; i < count; ++i) sums[0] += std::abs(f[i] - g[i]);
  return sum_of(sums);
}

MDBD_VECTORISED
void l1_of_all(const float* point, const float* points, std::size_t dimension, float* distances,
               std::size_t count) {
  for (std::size_t row = 0; row < count; ++row) {
    const float* other = points + row * dimension;
    alignas(32) float sums[lanes] = {};
    for (std::size_t i = 0; i < dimension; i += lanes) {
      MDBD_LANES
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        sums[lane] += std::abs(point[i + lane] - other[i + lane]);
      }
    }
    distances[row] = sum_of(sums);
  }
}

}  // namespace

double block_distance(std::span<const float> f, std::span<const float> g,
                      std::span<const MetricBlock> blocks) {
  double distance = 0.0;
  for (const MetricBlock& block : blocks) {
    const float* left = f.data() + block.first;
    const float* right = g.data() + block.first;
    distance += block.weight * (block.norm == PointNorm::l1
                                    ? l1(left, right, block.count)
                                    : std::sqrt(squared_l2(left, right, block.count)));
  }
  return distance;
}

void l1_distances(std::span<const float> point, std::span<const float> points,
                  std::span<float> distances) {
  l1_of_all(point.data(), points.data(), point.size(), distances.data(), distances.size());
}

}  // namespace mdbd
