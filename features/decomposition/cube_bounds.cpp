#include "features/decomposition/cube_bounds.h"

#include <algorithm>
#include <cmath>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

constexpr std::size_t lanes = 4;  // loops run over groups of so many witnesses
constexpr std::size_t capacity = WitnessLanes::capacity;
static_assert(capacity % lanes == 0);

using Values = double[capacity];

std::size_t padded(std::size_t count) { return (count + lanes - 1) / lanes * lanes; }

// What witnesses allow at the nodes of a grid: `side` to a side, `step` apart, x fastest. Lanes
// without a witness repeat the last one.
template <int side>
MDBD_PART_OF_CALLER inline void measure_grid(const WitnessLanes& witnesses,
                                             const Eigen::Vector3d& lowest, double step,
                                             Values* values) {
  WitnessLanes w = witnesses;
  const std::size_t end = padded(w.count);
  while (w.count < end) {
    w.add({{w.center[0][w.count - 1], w.center[1][w.count - 1], w.center[2][w.count - 1]},
           w.radius[w.count - 1]});
  }
  constexpr int nodes = side * side * side;
  for (int node = 0; node < nodes; ++node) {
    const double x = lowest.x() + step * (node % side);
    const double y = lowest.y() + step * (node / side % side);
    const double z = lowest.z() + step * (node / (side * side));
    for (std::size_t begin = 0; begin < end; begin += lanes) {
      MDBD_LANES
      for (std::size_t i = begin; i < begin + lanes; ++i) {
        const double dx = x - w.center[0][i];
        const double dy = y - w.center[1][i];
        const double dz = z - w.center[2][i];
        values[node][i] = std::sqrt(dx * dx + dy * dy + dz * dz) - w.radius[i];
      }
    }
  }
  for (std::size_t i = 0; i < witnesses.count; ++i) {
    if (w.piece[i] == nullptr) continue;
    double distances[nodes];
    if constexpr (side == 2) {
      w.piece[i]->measure_corners(lowest, step, distances);
    } else {
      w.piece[i]->measure_octants(lowest, step, distances);
    }
    for (int node = 0; node < nodes; ++node) values[node][i] = distances[node];
  }
}

// Affine bounds from the values at the corners of a cube. What witnesses allow is convex, and so is
// its difference from an affine function: both are largest at a corner. The slope is the one that
// fits the corners best.
MDBD_PART_OF_CALLER inline CubeBounds fit(const Values* const (&corners)[8], std::size_t count,
                                          const CubePreference& rank, double half_size) {
  const double per_corner = 0.125 / half_size;
  const std::size_t end = padded(count);
  CubeBounds bounds;
  bounds.count = count;
  alignas(32) Values largest;
  for (std::size_t begin = 0; begin < end; begin += lanes) {
    MDBD_LANES
    for (std::size_t i = begin; i < begin + lanes; ++i) {
      const double v0 = (*corners[0])[i];
      const double v1 = (*corners[1])[i];
      const double v2 = (*corners[2])[i];
      const double v3 = (*corners[3])[i];
      const double v4 = (*corners[4])[i];
      const double v5 = (*corners[5])[i];
      const double v6 = (*corners[6])[i];
      const double v7 = (*corners[7])[i];
      const double sx = per_corner * ((v1 - v0) + (v3 - v2) + (v5 - v4) + (v7 - v6));
      const double sy = per_corner * ((v2 - v0) + (v3 - v1) + (v6 - v4) + (v7 - v5));
      const double sz = per_corner * ((v4 - v0) + (v5 - v1) + (v6 - v2) + (v7 - v3));
      const double hx = half_size * sx;
      const double hy = half_size * sy;
      const double hz = half_size * sz;
      const double a = std::max(std::max(v0 + (hx + hy + hz), v7 - (hx + hy + hz)),
                                std::max(v1 - (hx - hy - hz), v6 + (hx - hy - hz)));
      const double b = std::max(std::max(v2 - (hy - hx - hz), v5 + (hy - hx - hz)),
                                std::max(v3 - (hx + hy - hz), v4 + (hx + hy - hz)));
      const double offset = std::max(a, b);
      const double highest = std::max(std::max(std::max(v0, v1), std::max(v2, v3)),
                                      std::max(std::max(v4, v5), std::max(v6, v7)));

      const double steepness = std::abs(sx) + std::abs(sy) + std::abs(sz);
      const double coupled = rank.coupling * offset;
      const double rank_x = sx * rank.factor + coupled * rank.direction.x();
      const double rank_y = sy * rank.factor + coupled * rank.direction.y();
      const double rank_z = sz * rank.factor + coupled * rank.direction.z();
      const double rank_offset = offset * rank.factor + rank.product * steepness;
      bounds.offset[i] = rank_offset;
      bounds.slope[0][i] = rank_x;
      bounds.slope[1][i] = rank_y;
      bounds.slope[2][i] = rank_z;
      const double reach =
          rank_offset + half_size * (std::abs(rank_x) + std::abs(rank_y) + std::abs(rank_z));
      largest[i] = std::min(reach, highest * rank.largest_factor);
    }
  }
  bounds.smallest = *std::min_element(largest, largest + count);
  return bounds;
}

}  // namespace

MDBD_VECTORISED
CubeBounds bound_over_cube(const WitnessLanes& witnesses, const Preference& preference,
                           const Eigen::Vector3d& center, double half_size) {
  alignas(32) Values values[8];
  measure_grid<2>(witnesses, center.array() - half_size, 2.0 * half_size, values);
  const Values* const corners[8] = {&values[0], &values[1], &values[2], &values[3],
                                    &values[4], &values[5], &values[6], &values[7]};
  return fit(corners, witnesses.count, preference.over_cube(center, half_size), half_size);
}

MDBD_VECTORISED
static void measure_octants(const WitnessLanes& witnesses, const Eigen::Vector3d& center,
                            double half_size, Values* values) {
  measure_grid<3>(witnesses, center.array() - half_size, half_size, values);
}

OctantBounds::OctantBounds(const WitnessLanes& witnesses, const Eigen::Vector3d& center,
                           double half_size)
    : center_(center), half_size_(half_size), count_(witnesses.count) {
  measure_octants(witnesses, center, half_size, values_);
}

MDBD_VECTORISED
CubeBounds OctantBounds::of_octant(int octant, const Preference& preference) const {
  Eigen::Vector3d center = center_;
  int lowest = 0;
  for (int axis = 0, stride = 1; axis < 3; ++axis, stride *= 3) {
    const int is_upper = octant >> axis & 1;
    center[axis] += (is_upper - 0.5) * half_size_;
    lowest += is_upper * stride;
  }
  const Values* const corners[8] = {
      &values_[lowest],     &values_[lowest + 1],  &values_[lowest + 3],  &values_[lowest + 4],
      &values_[lowest + 9], &values_[lowest + 10], &values_[lowest + 12], &values_[lowest + 13]};
  return fit(corners, count_, preference.over_cube(center, 0.5 * half_size_), 0.5 * half_size_);
}

}  // namespace mdbd
