#include "features/decomposition/ball_set.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mdbd {
namespace {

constexpr std::size_t max_wanted = 16;

/// The nearest balls found so far, nearest first.
class Ranking {
 public:
  Ranking(std::span<std::uint32_t> balls, double limit)
      : balls_(balls.first(std::min(balls.size(), max_wanted))), limit_(limit) {}

  std::size_t size() const { return size_; }

  void offer(std::uint32_t ball, double gap) {
    if (gap > limit_) return;
    if (is_full() && !comes_before(ball, gap, size_ - 1)) return;
    std::size_t at = is_full() ? size_ - 1 : size_++;
    for (; at > 0 && comes_before(ball, gap, at - 1); --at) {
      gaps_[at] = gaps_[at - 1];
      balls_[at] = balls_[at - 1];
    }
    gaps_[at] = gap;
    balls_[at] = ball;
  }

 private:
  bool is_full() const { return size_ == balls_.size(); }
  bool comes_before(std::uint32_t ball, double gap, std::size_t other) const {
    return gap != gaps_[other] ? gap < gaps_[other] : ball < balls_[other];
  }

  std::span<std::uint32_t> balls_;
  double limit_;
  std::array<double, max_wanted> gaps_;
  std::size_t size_ = 0;
};

}  // namespace

BallSet::BallSet(const Ball& domain)
    : corner_(domain.center.array() - domain.radius),
      part_size_(2.0 * domain.radius / parts),
      lists_(static_cast<std::size_t>(parts) * parts * parts) {}

int BallSet::part_along(int axis, double coordinate) const {
  const double part = (coordinate - corner_[axis]) / part_size_;
  return static_cast<int>(std::clamp(part, 0.0, parts - 1.0));
}

std::span<const std::uint32_t> BallSet::balls_around(const Eigen::Vector3d& point) const {
  const int part =
      part_along(0, point[0]) + parts * (part_along(1, point[1]) + parts * part_along(2, point[2]));
  return lists_[part];
}

void BallSet::add(const Ball& ball, double reach) {
  constexpr double rounding = 1.0 + 1e-9;
  const auto number = static_cast<std::uint32_t>(balls_.size());
  balls_.push_back(ball);
  const double influence = (ball.radius + reach) * rounding;
  std::array<int, 3> first;
  std::array<int, 3> last;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = part_along(axis, ball.center[axis] - influence);
    last[axis] = part_along(axis, ball.center[axis] + influence);
  }
  for (int z = first[2]; z <= last[2]; ++z) {
    for (int y = first[1]; y <= last[1]; ++y) {
      for (int x = first[0]; x <= last[0]; ++x) {
        lists_[x + parts * (y + parts * z)].push_back(number);
      }
    }
  }
}

std::size_t BallSet::update_nearest(const Eigen::Vector3d& point, double limit, std::size_t first,
                                    std::span<std::uint32_t> nearest, std::size_t known) const {
  std::array<std::uint32_t, max_wanted> old{};
  std::copy_n(nearest.begin(), known, old.begin());
  Ranking ranking(nearest, limit);
  const auto offer = [&](std::uint32_t ball) {
    ranking.offer(ball, (point - balls_[ball].center).norm() - balls_[ball].radius);
  };
  std::for_each_n(old.begin(), known, offer);
  const auto around = balls_around(point);
  for (auto ball = around.rbegin(); ball != around.rend() && *ball >= first; ++ball) offer(*ball);
  return ranking.size();
}

bool BallSet::has_near(const Eigen::Vector3d& point, double limit, std::size_t first) const {
  const auto around = balls_around(point);
  for (auto ball = around.rbegin(); ball != around.rend() && *ball >= first; ++ball) {
    const double reach = limit + balls_[*ball].radius;
    if ((point - balls_[*ball].center).squaredNorm() <= reach * reach) return true;
  }
  return false;
}

bool BallSet::is_clear(const Ball& ball, std::size_t first) const {
  return std::all_of(balls_.begin() + static_cast<std::ptrdiff_t>(first), balls_.end(),
                     [&](const Ball& other) {
                       return (ball.center - other.center).norm() - other.radius >= ball.radius;
                     });
}

}  // namespace mdbd
