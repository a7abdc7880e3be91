#include "features/decomposition/cube_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

constexpr std::size_t lanes = 4;  // loops run over groups of so many
constexpr std::size_t capacity = WitnessLanes::capacity;
static_assert(capacity % lanes == 0);

// Fills the last group of lanes by repeating the last witness. @returns the number of lanes
std::size_t fill_up(WitnessLanes& witnesses) {
  const std::size_t last = witnesses.count - 1;
  const std::size_t end = (witnesses.count + lanes - 1) / lanes * lanes;
  for (std::size_t i = witnesses.count; i < end; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      witnesses.center[axis][i] = witnesses.center[axis][last];
      witnesses.slope[axis][i] = witnesses.slope[axis][last];
    }
    witnesses.radius[i] = witnesses.radius[last];
  }
  return end;
}

}  // namespace

// A convex function less a linear one is convex, too, and so largest at a corner of the cube.
MDBD_VECTORISED
CubeBounds bound_over_cube(WitnessLanes& witnesses, const Preference& preference,
                           const Eigen::Vector3d& center, double half_size) {
  const std::size_t end = fill_up(witnesses);
  const WitnessLanes& w = witnesses;
  const CubePreference rank = preference.over_cube(center, half_size);
  const double x = center.x();
  const double y = center.y();
  const double z = center.z();
  alignas(32) double farthest[capacity];  // largest distance of a corner
  alignas(32) double constant[capacity];  // of the affine bound of the distance
  for (std::size_t begin = 0; begin < end; begin += lanes) {
    double far[lanes] = {};
    double highest[lanes];
    std::fill_n(highest, lanes, -std::numeric_limits<double>::infinity());
    for (int corner = 0; corner < 8; ++corner) {
      const double ox = (corner & 1) != 0 ? half_size : -half_size;
      const double oy = (corner & 2) != 0 ? half_size : -half_size;
      const double oz = (corner & 4) != 0 ? half_size : -half_size;
      MDBD_LANES
      for (std::size_t i = 0; i < lanes; ++i) {
        const double cx = x + ox - w.center[0][begin + i];
        const double cy = y + oy - w.center[1][begin + i];
        const double cz = z + oz - w.center[2][begin + i];
        const double distance = std::sqrt(cx * cx + cy * cy + cz * cz);
        const double rise = ox * w.slope[0][begin + i] + oy * w.slope[1][begin + i] +
                            oz * w.slope[2][begin + i];
        far[i] = std::max(far[i], distance);
        highest[i] = std::max(highest[i], distance - rise);
      }
    }
    std::copy_n(far, lanes, farthest + begin);
    std::copy_n(highest, lanes, constant + begin);
  }
  for (std::size_t i = 0; i < w.count; ++i) {
    if (w.piece[i] == nullptr) continue;
    const DistanceBound bound = w.piece[i]->bound_over_cube(
        center, half_size, {w.slope[0][i], w.slope[1][i], w.slope[2][i]});
    farthest[i] = bound.largest;
    constant[i] = bound.constant;
  }

  CubeBounds bounds;
  for (std::size_t begin = 0; begin < end; begin += lanes) {
    for (std::size_t i = begin; i < begin + lanes; ++i) {
      const double offset = constant[i] - w.radius[i];
      const double sx = w.slope[0][i];
      const double sy = w.slope[1][i];
      const double sz = w.slope[2][i];
      const double steepness = std::abs(sx) + std::abs(sy) + std::abs(sz);
      const double coupled = rank.coupling * offset;
      const double rank_x = sx * rank.factor + coupled * rank.direction.x();
      const double rank_y = sy * rank.factor + coupled * rank.direction.y();
      const double rank_z = sz * rank.factor + coupled * rank.direction.z();
      bounds.offset[i] = offset * rank.factor + rank.product * steepness;
      bounds.slope[0][i] = rank_x;
      bounds.slope[1][i] = rank_y;
      bounds.slope[2][i] = rank_z;
      const double reach =
          bounds.offset[i] + half_size * (std::abs(rank_x) + std::abs(rank_y) + std::abs(rank_z));
      farthest[i] = std::min(reach, (farthest[i] - w.radius[i]) * rank.largest_factor);
    }
  }
  bounds.smallest = *std::min_element(farthest, farthest + w.count);
  return bounds;
}

}  // namespace mdbd
