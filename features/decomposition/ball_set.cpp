#include "features/decomposition/ball_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mdbd {
namespace {

constexpr std::size_t block_size = 64;
constexpr std::size_t max_wanted = 16;

}  // namespace

void BallSet::add(const Ball& ball) {
  x_.push_back(ball.center.x());
  y_.push_back(ball.center.y());
  z_.push_back(ball.center.z());
  radius_.push_back(ball.radius);
}

std::size_t BallSet::find_nearest(const Eigen::Vector3d& point, double limit,
                                  std::span<Witness> nearest) const {
  const std::size_t wanted = std::min(nearest.size(), max_wanted);
  std::array<double, max_wanted> gaps;
  std::array<std::size_t, max_wanted> indices;
  std::size_t found = 0;
  std::array<double, block_size> block;
  for (std::size_t begin = 0; begin < size(); begin += block_size) {
    const std::size_t count = std::min(block_size, size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      const double dx = x_[begin + i] - point.x();
      const double dy = y_[begin + i] - point.y();
      const double dz = z_[begin + i] - point.z();
      block[i] = std::sqrt(dx * dx + dy * dy + dz * dz) - radius_[begin + i];
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (block[i] > limit || (found == wanted && block[i] >= gaps[found - 1])) continue;
      std::size_t at = found < wanted ? found++ : found - 1;
      for (; at > 0 && gaps[at - 1] > block[i]; --at) {
        gaps[at] = gaps[at - 1];
        indices[at] = indices[at - 1];
      }
      gaps[at] = block[i];
      indices[at] = begin + i;
    }
  }
  for (std::size_t k = 0; k < found; ++k) {
    const std::size_t i = indices[k];
    nearest[k] = {{x_[i], y_[i], z_[i]}, radius_[i]};
  }
  return found;
}

double BallSet::gap(const Eigen::Vector3d& point) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<Witness, 1> nearest;
  return find_nearest(point, infinity, nearest) > 0 ? nearest[0].value(point) : infinity;
}

}  // namespace mdbd
