#pragma once

#include <Eigen/Core>

#include "features/core/ball.h"
#include "features/decomposition/max_min_program.h"

namespace mdbd {

/// Decides between balls of equal radius in a way that does not depend on how the shape lies: the
/// one farther from a point of reference comes first. Plates, rods and pipes have maxima that can
/// slide; this slides them until something holds them, and fills the shape from one side.
///
/// The decision is part of what is maximised: rank(x) = d_i(x) * factor(x), where the factor grows
/// with the distance from 1 to 1 + weight. A ball that wins by its place is smaller than the
/// largest by at most `weight`, relative to its radius.
class Preference {
 public:
  static constexpr double weight = 1e-5;

  /// For the first balls: away from the centre of the enclosing ball.
  static Preference outward(const Ball& enclosing) {
    return {enclosing.center, 0.0, weight / enclosing.radius};
  }

  /// Away from a point far out in the direction of the first ball that is not in the centre, so
  /// that balls of equal radius fill a shape in nearly plane layers, beginning opposite to that
  /// ball.
  /// @pre first is not in the centre
  static Preference opposite(const Ball& enclosing, const Ball& first) {
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

  /// Turns an affine bound of d_i over the axis-aligned cube around x into one of the rank. It is
  /// not above the product of both, where d_i is positive, by more than terms of second order.
  AffineFunction apply_over_cube(const AffineFunction& bound, const Eigen::Vector3d& x,
                                 double half_size) const {
    const Eigen::Vector3d offset = x - reference_;
    const double distance = offset.norm();
    if (distance <= 2.0 * half_size) {
      const double factor = largest_factor(x, half_size);
      return {bound.offset * factor, bound.slope * factor};
    }
    // The distance from the reference is at most distance + direction . s + 3/2 h^2 / distance.
    const Eigen::Vector3d direction = offset / distance;
    const double squared = half_size * half_size;
    const double factor = factor_at(distance + 1.5 * squared / distance);
    const double product = squared * bound.slope.lpNorm<1>() * direction.lpNorm<1>();
    return {bound.offset * factor + slope_ * product,
            bound.slope * factor + slope_ * bound.offset * direction};
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
