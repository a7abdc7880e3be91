#include "features/descriptor/spherical_harmonics.h"

#include <cmath>
#include <numbers>

namespace mdbd {
namespace {

std::size_t index_of(int l, int m) { return static_cast<std::size_t>(l * l + l + m); }

// sqrt((2l + 1) / (4 pi) (l - m)! / (l + m)!), and sqrt(2) times that for m > 0.
double norm_of(int l, int m) {
  double ratio = 1.0;
  for (int i = l - m + 1; i <= l + m; ++i) ratio /= i;
  return std::sqrt((m > 0 ? 2 : 1) * (2 * l + 1) / (4 * std::numbers::pi) * ratio);
}

}  // namespace

SphericalHarmonics::SphericalHarmonics(int degree)
    : degree_(degree), norms_(harmonic_count(degree)) {
  for (int l = 0; l <= degree; ++l) {
    for (int m = 0; m <= l; ++m) norms_[index_of(l, m)] = norm_of(l, m);
  }
}

// With P_l^m(z) = sin^m(theta) Q_l^m(z) the factor sin^m goes with cos(m phi) and sin(m phi): they
// are the real and imaginary part of (x + iy)^m, so that nothing is divided by sin(theta).
void SphericalHarmonics::evaluate(const Eigen::Vector3d& direction,
                                  std::span<double> values) const {
  const double z = direction.z();
  double real = 1.0;
  double imaginary = 0.0;
  double first = 1.0;  // Q_m^m = (2m - 1)!!
  for (int m = 0; m <= degree_; ++m) {
    double before = 0.0;
    double current = first;
    for (int l = m; l <= degree_; ++l) {
      const double scaled = norms_[index_of(l, m)] * current;
      values[index_of(l, -m)] = scaled * imaginary;
      values[index_of(l, m)] = scaled * real;
      const double next = ((2 * l + 1) * z * current - (l + m) * before) / (l - m + 1);
      before = current;
      current = next;
    }
    first *= 2 * m + 1;
    const double turned = direction.x() * real - direction.y() * imaginary;
    imaginary = direction.x() * imaginary + direction.y() * real;
    real = turned;
  }
}

void append_amplitudes(std::span<const double> coefficients, int degree, double factor,
                       std::vector<double>& amplitudes) {
  for (int l = 0; l <= degree; ++l) {
    double energy = 0.0;
    for (int m = -l; m <= l; ++m) {
      const double coefficient = factor * coefficients[index_of(l, m)];
      energy += coefficient * coefficient;
    }
    amplitudes.push_back(std::sqrt(4 * std::numbers::pi * energy));
  }
}

Eigen::Vector3d direction_of(const Eigen::Vector3d& point) {
  const double distance = point.norm();
  if (!(distance > 0)) return Eigen::Vector3d::UnitZ();
  return point / distance;
}

}  // namespace mdbd
