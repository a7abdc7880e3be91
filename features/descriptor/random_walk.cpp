#include "features/descriptor/random_walk.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mdbd {
namespace {

// Scales a distribution to sum 1; false if nothing is left of it.
bool normalise(std::vector<double>& distribution) {
  const double mass = std::accumulate(distribution.begin(), distribution.end(), 0.0);
  if (!(mass > 0)) return false;
  for (double& value : distribution) value /= mass;
  return true;
}

// W p: every ball hands its probability to its neighbours in equal parts.
std::vector<double> step(const ContactGraph& graph, const std::vector<double>& distribution) {
  std::vector<double> next(distribution.size(), 0.0);
  for (std::size_t j = 0; j < distribution.size(); ++j) {
    const auto& neighbours = graph.neighbours[j];
    for (const std::uint32_t i : neighbours) {
      next[i] += distribution[j] / static_cast<double>(neighbours.size());
    }
  }
  return next;
}

}  // namespace

RandomWalk random_walk(const ContactGraph& graph, std::span<const Ball> balls, int steps) {
  const std::vector<double> zeros(balls.size(), 0.0);
  const RandomWalk lost{std::vector<std::vector<double>>(steps, zeros), false};
  std::vector<double> distribution;
  for (const Ball& ball : balls) distribution.push_back(ball.radius);
  if (!normalise(distribution)) return lost;

  RandomWalk walk;
  for (int t = 1; t <= steps; ++t) {
    distribution = step(graph, distribution);
    if (!normalise(distribution)) return lost;
    walk.distributions.push_back(distribution);
  }
  return walk;
}

std::vector<double> walk_sums(const RandomWalk& walk, int counted_balls, double damping) {
  std::vector<double> sums;
  for (const std::vector<double>& distribution : walk.distributions) {
    const auto counted = std::min<std::size_t>(counted_balls, distribution.size());
    const double sum = std::accumulate(distribution.begin(), distribution.begin() + counted, 0.0);
    sums.push_back(std::pow(damping, static_cast<int>(sums.size()) + 1) * sum);
  }
  return sums;
}

}  // namespace mdbd
