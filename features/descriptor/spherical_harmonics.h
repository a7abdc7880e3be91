#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// How many spherical harmonics there are up to a degree.
constexpr std::size_t harmonic_count(int degree) {
  return static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(degree + 1);
}

/// Evaluates the real spherical harmonics, orthonormal on the unit sphere, up to a degree. A
/// function on the sphere with the coefficients f_lm has in degree l the energy sum over m of
/// f_lm^2, which no rotation or reflection changes.
class SphericalHarmonics {
 public:
  explicit SphericalHarmonics(int degree);

  int degree() const { return degree_; }

  /// @param direction a unit vector
  /// @param values Y_lm at [l * l + l + m] for all l up to degree() and |m| <= l
  /// @pre values.size() == harmonic_count(degree())
  void evaluate(const Eigen::Vector3d& direction, std::span<double> values) const;

 private:
  int degree_;
  std::vector<double> norms_;  // of Y_lm at [l * l + l + m], m >= 0
};

/// Appends the amplitude of each degree of a function on the sphere: the root of its energy, scaled
/// so that degree 0 gives the absolute value of the function's integral.
/// @param coefficients of the function, at [l * l + l + m]
/// @param factor by which the function is multiplied
void append_amplitudes(std::span<const double> coefficients, int degree, double factor,
                       std::vector<double>& amplitudes);

/// The direction of a point from the origin; of the origin itself, any.
Eigen::Vector3d direction_of(const Eigen::Vector3d& point);

}  // namespace mdbd
