#include "features/distance/enclosing_ball.h"

#include <optional>
#include <vector>

#include <Eigen/Dense>

namespace mdbd {
namespace {

constexpr double rounding = 1e-12;
constexpr int max_support = 4;

using Points = std::vector<Eigen::Vector3d>;

bool encloses(const Ball& ball, const Points& points) {
  for (const Eigen::Vector3d& point : points) {
    if ((point - ball.center).norm() > ball.radius * (1 + rounding)) return false;
  }
  return true;
}

// The smallest ball with all points on its surface, if they are affinely independent.
std::optional<Ball> circumscribed_ball(const Points& points) {
  const auto edge_count = static_cast<Eigen::Index>(points.size()) - 1;
  if (edge_count == 0) return Ball{points[0], 0.0};
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> edges(3, edge_count);
  for (Eigen::Index i = 0; i < edge_count; ++i) edges.col(i) = points[i + 1] - points[0];
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> gram =
      edges.transpose() * edges;
  const Eigen::FullPivLU<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>> lu(gram);
  if (!lu.isInvertible()) return std::nullopt;
  const Eigen::Vector3d offset = edges * lu.solve(0.5 * gram.diagonal());
  return Ball{points[0] + offset, offset.norm()};
}

// The smallest ball enclosing `support` and `added`, which lies outside the support's own ball, so
// that it is on the surface. `support` becomes the points that hold the new ball.
std::optional<Ball> smallest_ball(Points& support, const Eigen::Vector3d& added) {
  Points all = support;
  all.push_back(added);
  const std::size_t old_size = support.size();
  std::optional<Ball> best;
  for (unsigned subset = 0; subset < 1U << old_size; ++subset) {
    Points chosen{added};
    for (std::size_t i = 0; i < old_size; ++i) {
      if ((subset >> i & 1U) != 0) chosen.push_back(all[i]);
    }
    if (chosen.size() > max_support) continue;
    const std::optional<Ball> ball = circumscribed_ball(chosen);
    if (!ball || (best && ball->radius >= best->radius) || !encloses(*ball, all)) continue;
    best = ball;
    support = chosen;
  }
  return best;
}

Eigen::Vector3d farthest_point(std::span<const Eigen::Vector3d> points,
                               const Eigen::Vector3d& from) {
  Eigen::Vector3d farthest = points[0];
  double largest = -1.0;
  for (const Eigen::Vector3d& point : points) {
    const double squared = (point - from).squaredNorm();
    if (squared > largest) {
      largest = squared;
      farthest = point;
    }
  }
  return farthest;
}

}  // namespace

// The ball of a few support points grows by the farthest point until no point is outside (Gärtner,
// Fast and robust smallest enclosing balls, 1999).
Ball enclosing_ball(std::span<const Eigen::Vector3d> points) {
  Points support{points[0]};
  Ball ball{points[0], 0.0};
  while (true) {
    const Eigen::Vector3d farthest = farthest_point(points, ball.center);
    const double distance = (farthest - ball.center).norm();
    if (distance <= ball.radius * (1 + rounding)) return ball;
    const std::optional<Ball> larger = smallest_ball(support, farthest);
    // Without growth only rounding is left: what sticks out is taken in.
    if (!larger || larger->radius <= ball.radius) return {ball.center, distance};
    ball = *larger;
  }
}

}  // namespace mdbd
