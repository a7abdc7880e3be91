#include "features/decomposition/ball_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

constexpr std::size_t block_size = BallSet::block_size;
constexpr std::size_t max_wanted = 16;
constexpr double rounding = 1.0 - 1e-12;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The nearest balls found so far, nearest first.
class Ranking {
 public:
  Ranking(std::span<std::uint32_t> balls, double limit)
      : balls_(balls.first(std::min(balls.size(), max_wanted))), limit_(limit) {}

  /// What is farther is not wanted.
  double limit() const { return limit_; }
  std::size_t size() const { return size_; }

  void offer(std::uint32_t ball, double gap) {
    if (gap > limit_ || (is_full() && gap >= limit_)) return;
    std::size_t at = is_full() ? size_ - 1 : size_++;
    for (; at > 0 && gaps_[at - 1] > gap; --at) {
      gaps_[at] = gaps_[at - 1];
      balls_[at] = balls_[at - 1];
    }
    gaps_[at] = gap;
    balls_[at] = ball;
    if (is_full()) limit_ = gaps_[size_ - 1];
  }

 private:
  bool is_full() const { return size_ == balls_.size(); }

  std::span<std::uint32_t> balls_;
  double limit_;
  std::array<double, max_wanted> gaps_;
  std::size_t size_ = 0;
};

}  // namespace

void BallSet::add(const Ball& ball) {
  const std::size_t lane = size_ % block_size;
  if (lane == 0) {
    Block empty;
    for (auto* values : {&empty.x, &empty.y, &empty.z}) std::ranges::fill(*values, infinity);
    std::ranges::fill(empty.radius, 0.0);
    blocks_.push_back(empty);
  }
  Block& block = blocks_.back();
  block.x[lane] = ball.center.x();
  block.y[lane] = ball.center.y();
  block.z[lane] = ball.center.z();
  block.radius[lane] = ball.radius;
  ++size_;
}

MDBD_VECTORISED
std::size_t BallSet::update_nearest(const Eigen::Vector3d& point, double limit, std::size_t first,
                                    std::span<std::uint32_t> nearest, std::size_t known) const {
  std::array<std::uint32_t, max_wanted> old{};
  std::copy_n(nearest.begin(), known, old.begin());
  Ranking ranking(nearest, limit);
  for (std::size_t i = 0; i < known; ++i) ranking.offer(old[i], witness(old[i]).value(point));
  const double x = point.x();
  const double y = point.y();
  const double z = point.z();
  for (std::size_t b = first / block_size; b < blocks_.size(); ++b) {
    const Block& block = blocks_[b];
    alignas(32) double squared[block_size];
    alignas(32) double excess[block_size];  // how far a ball is beyond the limit, in squares
    for (std::size_t i = 0; i < block_size; ++i) {
      const double dx = block.x[i] - x;
      const double dy = block.y[i] - y;
      const double dz = block.z[i] - z;
      squared[i] = dx * dx + dy * dy + dz * dz;
      const double reach = block.radius[i] + ranking.limit();
      excess[i] = rounding * squared[i] - reach * reach;
    }
    for (std::size_t half = block_size / 2; half >= 1; half /= 2) {
      for (std::size_t i = 0; i < half; ++i) excess[i] = std::min(excess[i], excess[i + half]);
    }
    if (excess[0] > 0) continue;
    const std::size_t begin = b * block_size;
    const std::size_t end = std::min(begin + block_size, size_);
    for (std::size_t i = std::max(begin, first); i < end; ++i) {
      ranking.offer(static_cast<std::uint32_t>(i),
                    std::sqrt(squared[i - begin]) - block.radius[i - begin]);
    }
  }
  return ranking.size();
}

double BallSet::gap(const Eigen::Vector3d& point, double limit) const {
  std::array<std::uint32_t, 1> nearest;
  return find_nearest(point, limit, nearest) > 0 ? witness(nearest[0]).value(point) : limit;
}

}  // namespace mdbd
