#include "features/descriptor/ball_placement.h"

#include <array>
#include <cmath>

#include "features/descriptor/soft_bins.h"
#include "features/descriptor/spherical_harmonics.h"

namespace mdbd {
namespace {

constexpr SoftBins distance_bins{0.0, 3.0, placement_distances};
constexpr SoftBins log_radius_bins{-6.0, 0.0, placement_radii};  // base 2
constexpr std::size_t coefficients = harmonic_count(placement_degree);
constexpr std::size_t nodes = std::size_t{placement_distances} * placement_radii;

using Coefficients = std::array<double, coefficients>;

// The harmonics of the spot as which a ball is seen from the origin. A ball's second moment is
// r^2 / 5 along each axis; the heat kernel of that variance on the sphere, at distance D, dampens
// degree l by exp(-l (l + 1) r^2 / (10 D^2)).
Coefficients spot_of(const Ball& ball, const SphericalHarmonics& harmonics) {
  Coefficients spot{};
  harmonics.evaluate(direction_of(ball.center), spot);
  const double width = ball.radius / ball.center.norm();  // infinite at the origin
  for (int l = 1; l <= placement_degree; ++l) {
    const double damping = std::exp(-0.1 * l * (l + 1) * width * width);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) spot[i] *= damping;
  }
  return spot;
}

void add(Coefficients& sum, double weight, const Coefficients& spot) {
  for (std::size_t i = 0; i < coefficients; ++i) sum[i] += weight * spot[i];
}

}  // namespace

std::vector<double> ball_placement(std::span<const Ball> balls) {
  const SphericalHarmonics harmonics(placement_degree);
  double total = 0.0;
  for (const Ball& ball : balls) total += ball.radius * ball.radius;
  std::array<Coefficients, nodes> sums{};
  for (const Ball& ball : balls) {
    const double weight = ball.radius * ball.radius / total;
    const Coefficients spot = spot_of(ball, harmonics);
    const SoftBin distance = distance_bins.find(ball.center.norm());
    const SoftBin radius = log_radius_bins.find(std::log2(ball.radius));
    const std::size_t node = distance.lower * placement_radii + radius.lower;
    add(sums[node], weight * (1 - distance.share) * (1 - radius.share), spot);
    add(sums[node + 1], weight * (1 - distance.share) * radius.share, spot);
    add(sums[node + placement_radii], weight * distance.share * (1 - radius.share), spot);
    add(sums[node + placement_radii + 1], weight * distance.share * radius.share, spot);
  }
  std::vector<double> amplitudes;
  amplitudes.reserve(placement_size);
  for (const Coefficients& sum : sums) append_amplitudes(sum, placement_degree, 1.0, amplitudes);
  return amplitudes;
}

}  // namespace mdbd
