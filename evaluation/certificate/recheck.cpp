#include "evaluation/certificate/recheck.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "evaluation/certificate/mesh_measure.h"
#include "evaluation/certificate/rival_search.h"

namespace mdbd {
namespace {

// What share of a ball's radius a rival must have for the search to have reached the ball.
constexpr double reached_share = 0.99;

void raise(Violation& worst, double size, std::size_t ball) {
  if (size > worst.size) worst = {size, ball};
}

Violation measure_escape(const MeshMeasure& measure, std::span<const Ball> balls, double scale) {
  Violation worst;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Eigen::Vector3d& center = balls[i].center;
    const double distance = measure.distance(center);
    const double depth = measure.is_inside(center) ? distance : -distance;
    raise(worst, (balls[i].radius - depth) / scale, i);
  }
  return worst;
}

Violation measure_overlap(std::span<const Ball> balls, double scale) {
  Violation worst;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = (balls[i].center - balls[j].center).norm();
      raise(worst, (balls[i].radius + balls[j].radius - distance) / scale, i);
    }
  }
  return worst;
}

/// For each ball, the radius of the largest ball after it.
std::vector<double> largest_later_radii(std::span<const Ball> balls) {
  std::vector<double> radii(balls.size(), 0.0);
  for (std::size_t i = balls.size() - 1; i > 0; --i) {
    radii[i - 1] = std::max(radii[i], balls[i].radius);
  }
  return radii;
}

}  // namespace

RecheckedBalls recheck_balls(const TriangleMesh& mesh, std::span<const Ball> balls, double scale,
                             double minimum_radius, const RecheckOptions& options) {
  const MeshMeasure measure(mesh);
  RecheckedBalls result;
  result.escape = measure_escape(measure, balls, scale);
  result.overlap = measure_overlap(balls, scale);
  result.excess.size = -std::numeric_limits<double>::infinity();

  // A climb stays inside, unless it leaves through a hole of the surface.
  const auto challenge = [&](std::size_t i, double radius, const Ball& rival) {
    const double excess = rival.radius / radius - 1;
    const bool is_news = excess > std::max(0.0, result.excess.size);
    if (is_news && !measure.is_inside(rival.center)) return;
    raise(result.excess, excess, i);
  };
  RivalSearch search(measure, balls.front().radius, options);
  const std::vector<double> later_radii = largest_later_radii(balls);
  std::size_t reached = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Ball rival = search.find();
    if (rival.radius >= reached_share * balls[i].radius) ++reached;
    challenge(i, balls[i].radius, rival);
    challenge(i, balls[i].radius, search.find_near(balls[i].center));
    raise(result.excess, later_radii[i] / balls[i].radius - 1, i);
    search.place(balls[i]);
  }
  if (minimum_radius > 0) challenge(balls.size(), minimum_radius * scale, search.find());
  result.search_reach = static_cast<double>(reached) / static_cast<double>(balls.size());
  return result;
}

}  // namespace mdbd
