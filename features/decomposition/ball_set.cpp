#include "features/decomposition/ball_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mdbd {
namespace {

constexpr std::size_t block_size = 16;
constexpr std::size_t max_wanted = 16;
constexpr double rounding = 1.0 - 1e-12;
constexpr double infinity = std::numeric_limits<double>::infinity();

using Block = Eigen::Array<double, block_size, 1>;
using BlockMap = Eigen::Map<const Block>;

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
  if (size_ == x_.size()) {
    for (auto* values : {&x_, &y_, &z_, &radius_}) {
      values->resize(size_ + block_size, values == &radius_ ? 0.0 : infinity);
    }
  }
  x_[size_] = ball.center.x();
  y_[size_] = ball.center.y();
  z_[size_] = ball.center.z();
  radius_[size_] = ball.radius;
  ++size_;
}

std::size_t BallSet::update_nearest(const Eigen::Vector3d& point, double limit, std::size_t first,
                                    std::span<std::uint32_t> nearest, std::size_t known) const {
  std::array<std::uint32_t, max_wanted> old{};
  std::copy_n(nearest.begin(), known, old.begin());
  Ranking ranking(nearest, limit);
  for (std::size_t i = 0; i < known; ++i) ranking.offer(old[i], witness(old[i]).value(point));
  for (std::size_t begin = first / block_size * block_size; begin < size_; begin += block_size) {
    const BlockMap radius(&radius_[begin]);
    const Block squared = (BlockMap(&x_[begin]) - point.x()).square() +
                          (BlockMap(&y_[begin]) - point.y()).square() +
                          (BlockMap(&z_[begin]) - point.z()).square();
    const Block excess = rounding * squared - (radius + ranking.limit()).square();
    if (excess.minCoeff() > 0) continue;
    const std::size_t end = std::min(begin + block_size, size_);
    for (std::size_t i = std::max(begin, first); i < end; ++i) {
      ranking.offer(static_cast<std::uint32_t>(i), std::sqrt(squared[i - begin]) - radius_[i]);
    }
  }
  return ranking.size();
}

double BallSet::gap(const Eigen::Vector3d& point) const {
  std::array<std::uint32_t, 1> nearest;
  return find_nearest(point, infinity, nearest) > 0 ? witness(nearest[0]).value(point) : infinity;
}

}  // namespace mdbd
