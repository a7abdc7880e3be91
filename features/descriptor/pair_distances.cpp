#include "features/descriptor/pair_distances.h"

#include <cmath>

#include "features/descriptor/soft_bins.h"

namespace mdbd {
namespace {

constexpr SoftBins bins{0.0, 4.0, pair_distance_nodes};

// A point of a ball is at a mean square distance of 3/5 r^2 from its centre.
double distance_of(const Ball& a, const Ball& b) {
  return std::sqrt((a.center - b.center).squaredNorm() +
                   0.6 * (a.radius * a.radius + b.radius * b.radius));
}

}  // namespace

std::vector<double> pair_distances(std::span<const Ball> balls) {
  double total = 0.0;
  for (const Ball& ball : balls) total += ball.radius;
  std::vector<double> shares(pair_distance_nodes, 0.0);
  const auto add = [&](const Ball& a, const Ball& b, double weight) {
    const SoftBin bin = bins.find(distance_of(a, b));
    shares[bin.lower] += weight * (1 - bin.share);
    shares[bin.lower + 1] += weight * bin.share;
  };
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double weight = balls[i].radius / (total * total);
    for (std::size_t j = 0; j < i; ++j) add(balls[i], balls[j], 2 * weight * balls[j].radius);
    add(balls[i], balls[i], weight * balls[i].radius);
  }
  return shares;
}

}  // namespace mdbd
