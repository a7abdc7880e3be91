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

template <PointNorm norm>
MDBD_PART_OF_CALLER inline void add_differences(const float* point, const float* groups,
                                                std::size_t dimension, float* distances,
                                                std::size_t group_count) {
  for (std::size_t group = 0; group < group_count; ++group) {
    alignas(32) float sums[lanes] = {};
    for (std::size_t i = 0; i < dimension; ++i) {
      const float* others = groups + (group * dimension + i) * lanes;
      MDBD_LANES
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const float difference = point[i] - others[lane];
        sums[lane] += norm == PointNorm::l1 ? std::abs(difference) : difference * difference;
      }
    }
    MDBD_LANES
    for (std::size_t lane = 0; lane < lanes; ++lane) distances[group * lanes + lane] = sums[lane];
  }
}

MDBD_VECTORISED
void l1_of_groups(const float* point, const float* groups, std::size_t dimension, float* distances,
                  std::size_t group_count) {
  add_differences<PointNorm::l1>(point, groups, dimension, distances, group_count);
}

MDBD_VECTORISED
void squared_l2_of_groups(const float* point, const float* groups, std::size_t dimension,
                          float* distances, std::size_t group_count) {
  add_differences<PointNorm::l2>(point, groups, dimension, distances, group_count);
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

void grouped_distances(std::span<const float> point, std::span<const float> groups, PointNorm norm,
                       std::span<float> distances) {
  const auto compute = norm == PointNorm::l1 ? l1_of_groups : squared_l2_of_groups;
  compute(point.data(), groups.data(), point.size(), distances.data(), distances.size() / lanes);
}

}  // namespace mdbd
