#include "features/descriptor/solid_frame.h"

#include <cmath>

namespace mdbd {
namespace {

double cube(double x) { return x * x * x; }

}  // namespace

// Everything is taken relative to the first ball and its radius, so that neither a shape far from
// the origin loses digits nor a tiny or huge one overflows.
std::vector<Ball> to_solid_frame(std::span<const Ball> balls) {
  const Ball& first = balls.front();
  std::vector<Ball> result;
  result.reserve(balls.size());
  double volume = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const Ball& ball : balls) {
    result.push_back({(ball.center - first.center) / first.radius, ball.radius / first.radius});
    volume += cube(result.back().radius);
    moment += cube(result.back().radius) * result.back().center;
  }
  const Eigen::Vector3d centroid = moment / volume;
  double second_moment = 0.0;
  for (Ball& ball : result) {
    ball.center -= centroid;
    // A ball's own mean square distance from its centre is 3/5 r^2.
    second_moment +=
        cube(ball.radius) * (ball.center.squaredNorm() + 0.6 * ball.radius * ball.radius);
  }
  const double scale = std::sqrt(second_moment / volume);
  for (Ball& ball : result) {
    ball.center /= scale;
    ball.radius /= scale;
  }
  return result;
}

}  // namespace mdbd
