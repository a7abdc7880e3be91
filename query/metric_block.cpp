#include "query/metric_block.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <type_traits>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

constexpr std::size_t lanes = 8;
constexpr std::size_t byte_lanes = 32;

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

// L1 of 256 bytes fits in 16 bits, and takes half as long in them.
template <PointNorm norm>
using ByteSum = std::conditional_t<norm == PointNorm::l1, std::uint16_t, std::uint32_t>;

template <PointNorm norm>
MDBD_PART_OF_CALLER inline void add_differences(const std::uint8_t* point,
                                                const std::uint8_t* group, std::size_t dimension,
                                                ByteSum<norm>* sums) {
  for (std::size_t i = 0; i < dimension; ++i) {
    MDBD_LANES
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) {
      const int difference = point[i] - group[i * byte_lanes + lane];
      sums[lane] += static_cast<ByteSum<norm>>(norm == PointNorm::l1 ? std::abs(difference)
                                                                     : difference * difference);
    }
  }
}

template <PointNorm norm>
MDBD_PART_OF_CALLER inline std::size_t find_sums(const std::uint8_t* point,
                                                 const std::uint8_t* groups, std::size_t dimension,
                                                 std::size_t group_count, std::uint32_t limit,
                                                 GroupedPoint* found) {
  std::size_t count = 0;
  for (std::size_t group = 0; group < group_count; ++group) {
    alignas(32) ByteSum<norm> sums[byte_lanes] = {};
    add_differences<norm>(point, groups + group * dimension * byte_lanes, dimension, sums);
    ByteSum<norm> smallest = sums[0];
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) smallest = std::min(smallest, sums[lane]);
    if (smallest > limit) continue;
    for (std::size_t lane = 0; lane < byte_lanes; ++lane) {
      if (sums[lane] > limit) continue;
      found[count++] = {sums[lane], static_cast<std::uint32_t>(group * byte_lanes + lane)};
    }
  }
  return count;
}

MDBD_VECTORISED
std::size_t find_l1(const std::uint8_t* point, const std::uint8_t* groups, std::size_t dimension,
                    std::size_t group_count, std::uint32_t limit, GroupedPoint* found) {
  return find_sums<PointNorm::l1>(point, groups, dimension, group_count, limit, found);
}

MDBD_VECTORISED
std::size_t find_squared_l2(const std::uint8_t* point, const std::uint8_t* groups,
                            std::size_t dimension, std::size_t group_count, std::uint32_t limit,
                            GroupedPoint* found) {
  return find_sums<PointNorm::l2>(point, groups, dimension, group_count, limit, found);
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

std::size_t find_within(std::span<const std::uint8_t> point, std::span<const std::uint8_t> groups,
                        PointNorm norm, std::uint32_t limit, std::span<GroupedPoint> found) {
  const auto find = norm == PointNorm::l1 ? find_l1 : find_squared_l2;
  return find(point.data(), groups.data(), point.size(), found.size() / byte_lanes, limit,
              found.data());
}

}  // namespace mdbd
