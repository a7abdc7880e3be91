#pragma once

#include <Eigen/Core>

#include "features/core/ball.h"
#include "features/decomposition/max_min_program.h"

namespace mdbd {

/// The factor of the rank (Preference) over a cube. With an affine bound a + b . s of d_i, the rank
/// is at most a f + |b|_1 p + (b f + a c d) . s where d_i is positive: the product of both, with
/// its term of second order replaced by the largest that it can be.
struct CubePreference {
  double factor;                                        ///< f
  double coupling = 0.0;                                ///< c
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< d
  double product = 0.0;                                 ///< p
  double largest_factor;                                ///< of a point of the cube
};

/// Decides between balls of equal radius in a way that does not depend on how the shape lies: the
/// one farther from a point of reference comes first. Plates, rods and pipes have maxima that can
/// slide; this slides them until something holds them, and fills the shape from one side.
///
/// The decision is part of what is maximised: rank(x) = d_i(x) * factor(x), where the factor grows
/// with the distance from 1 to 1 + weight. A ball that wins by its place is smaller than the
/// largest by at most the weight, relative to its radius.
class Preference {
 public:
  /// For the first balls: away from the centre of the enclosing ball.
  static Preference outward(const Ball& enclosing, double weight) {
    return {enclosing.center, 0.0, weight / enclosing.radius};
  }

  /// Away from a point far out in the direction of the first ball that is not in the centre, so
  /// that balls of equal radius fill a shape in nearly plane layers, beginning opposite to that
  /// ball.
  /// @pre first is not in the centre
  static Preference opposite(const Ball& enclosing, const Ball& first, double weight) {
    constexpr double distance = 10.0;  // of the point of reference, in R
    const Eigen::Vector3d direction = (first.center - enclosing.center).normalized();
    return {enclosing.center + distance * enclosing.radius * direction,
            (distance - 1.0) * enclosing.radius, 0.5 * weight / enclosing.radius};
  }

  double factor(const Eigen::Vector3d& x) const { return factor_at((x - reference_).norm()); }

  /// The largest factor of a point of the axis-aligned cube.
  double largest_factor(const Eigen::Vector3d& middle, double half_size) const {
    return factor_at(((middle - reference_).cwiseAbs().array() + half_size).matrix().norm());
  }

  /// How affine bounds of d_i over the axis-aligned cube around x become bounds of the rank.
  CubePreference over_cube(const Eigen::Vector3d& x, double half_size) const {
    const double largest = largest_factor(x, half_size);
    const Eigen::Vector3d offset = x - reference_;
    const double distance = offset.norm();
    if (distance <= 2.0 * half_size) return {.factor = largest, .largest_factor = largest};
    // The distance from the reference is at most distance + direction . s + 3/2 h^2 / distance.
    const Eigen::Vector3d direction = offset / distance;
    const double squared = half_size * half_size;
    return {.factor = factor_at(distance + 1.5 * squared / distance),
            .coupling = slope_,
            .direction = direction,
            .product = slope_ * squared * direction.lpNorm<1>(),
            .largest_factor = largest};
  }

  /// Turns the first-order model of a bound of d_i around x into that of the rank.
  AffineFunction apply(const AffineFunction& model, const Eigen::Vector3d& x) const {
    const Eigen::Vector3d offset = x - reference_;
    const double distance = offset.norm();
    const double factor = factor_at(distance);
    if (!(distance > 0)) return {model.offset * factor, model.slope * factor};
    return {model.offset * factor,
            model.slope * factor + model.offset * slope_ / distance * offset};
  }

 private:
  Preference(const Eigen::Vector3d& reference, double least_distance, double slope)
      : reference_(reference), least_distance_(least_distance), slope_(slope) {}

  double factor_at(double distance) const { return 1.0 + slope_ * (distance - least_distance_); }

  Eigen::Vector3d reference_;
  double least_distance_;  // of a point in the enclosing ball
  double slope_;
};

}  // namespace mdbd
