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

WalkSums walk_sums(const ContactGraph& graph, std::span<const Ball> balls, int counted_balls,
                   int steps, double damping) {
  const WalkSums lost{std::vector<double>(steps, 0.0), false};
  std::vector<double> distribution;
  for (const Ball& ball : balls) distribution.push_back(ball.radius);
  if (!normalise(distribution)) return lost;

  WalkSums result;
  const auto counted = std::min<std::size_t>(counted_balls, balls.size());
  for (int t = 1; t <= steps; ++t) {
    distribution = step(graph, distribution);
    if (!normalise(distribution)) return lost;
    const double sum = std::accumulate(distribution.begin(), distribution.begin() + counted, 0.0);
    result.sums.push_back(std::pow(damping, t) * sum);
  }
  return result;
}

}  // namespace mdbd
