#include "features/descriptor/solid_harmonics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "features/descriptor/spherical_harmonics.h"

namespace mdbd {
namespace {

using std::numbers::pi;

constexpr const SoftBins& shells = solid_shell_nodes;
constexpr std::size_t coefficients = harmonic_count(solid_degree);

/// One number for each degree.
using Degrees = std::array<double, solid_degree + 1>;
/// Of one ball, by shell.
using ShellDegrees = std::array<Degrees, solid_shells>;

/// Gauss-Legendre quadrature on [-1, 1]; points are symmetric.
struct QuadraturePoint {
  double position;
  double weight;
};
constexpr std::array<QuadraturePoint, 3> half_quadrature{
    {{0.2386191860831969, 0.4679139345726910},
     {0.6612093864662645, 0.3607615730481386},
     {0.9324695142031521, 0.1713244923791704}}};

/// Zonal coefficients of the cap {cos(angle) >= t}: 2 pi times the integral of P_l from t to 1.
Degrees cap_harmonics(double t) {
  Degrees result{};
  result[0] = 2 * pi * (1 - t);
  double before = 1.0;
  double current = t;
  for (int l = 1; l <= solid_degree; ++l) {
    const double next = ((2 * l + 1) * t * current - l * before) / (l + 1);
    result[l] = 2 * pi * (before - next) / (2 * l + 1);
    before = current;
    current = next;
  }
  return result;
}

Degrees whole_sphere() { return cap_harmonics(-1.0); }

/// What the ball cuts from the sphere of radius rho, given that they meet.
Degrees cut(const Ball& ball, double distance, double rho) {
  const double t =
      (rho * rho + distance * distance - ball.radius * ball.radius) / (2 * rho * distance);
  return cap_harmonics(std::clamp(t, -1.0, 1.0));
}

/// Adds the integral of section(rho) rho^2 over [first, last], within which no node of the shells
/// lies.
template <typename Section>
void integrate_panel(ShellDegrees& sums, double first, double last, const Section& section) {
  const double half = 0.5 * (last - first);
  const double middle = 0.5 * (last + first);
  for (const QuadraturePoint& point : half_quadrature) {
    for (const double position : {-point.position, point.position}) {
      const double rho = middle + half * position;
      const Degrees degrees = section(rho);
      const SoftBin bin = shells.find(rho);
      const double weight = half * point.weight * rho * rho;
      for (int l = 0; l <= solid_degree; ++l) {
        sums[bin.lower][l] += weight * (1 - bin.share) * degrees[l];
        sums[bin.lower + 1][l] += weight * bin.share * degrees[l];
      }
    }
  }
}

/// The same over any interval: the hat functions have kinks at the nodes.
template <typename Section>
void integrate(ShellDegrees& sums, double first, double last, const Section& section) {
  for (std::size_t i = 0; i < shells.count && first < last; ++i) {
    const double node = shells.node(i);
    if (node <= first) continue;
    const double end = std::min(node, last);
    integrate_panel(sums, first, end, section);
    first = end;
  }
  if (first < last) integrate_panel(sums, first, last, section);
}

ShellDegrees harmonics_of(const Ball& ball, double distance) {
  ShellDegrees sums{};
  if (ball.radius > distance) {
    const Degrees all = whole_sphere();
    integrate(sums, 0.0, ball.radius - distance, [&](double) { return all; });
  }
  integrate(sums, std::abs(distance - ball.radius), distance + ball.radius,
            [&](double rho) { return cut(ball, distance, rho); });
  return sums;
}

}  // namespace

std::vector<double> solid_harmonics(std::span<const Ball> balls) {
  const SphericalHarmonics harmonics(solid_degree);
  std::array<std::array<double, coefficients>, solid_shells> sums{};
  std::array<double, coefficients> values{};
  double volume = 0.0;
  for (const Ball& ball : balls) {
    const double distance = ball.center.norm();
    harmonics.evaluate(direction_of(ball.center), values);
    const ShellDegrees own = harmonics_of(ball, distance);
    for (std::size_t shell = 0; shell < solid_shells; ++shell) {
      if (own[shell][0] == 0) continue;
      for (int l = 0; l <= solid_degree; ++l) {
        for (int i = l * l; i < (l + 1) * (l + 1); ++i) sums[shell][i] += own[shell][l] * values[i];
      }
    }
    volume += 4.0 / 3.0 * pi * ball.radius * ball.radius * ball.radius;
  }
  std::vector<double> amplitudes;
  amplitudes.reserve(solid_size);
  for (const auto& sum : sums) append_amplitudes(sum, solid_degree, 1 / volume, amplitudes);
  return amplitudes;
}

}  // namespace mdbd
