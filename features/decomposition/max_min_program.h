#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

namespace mdbd {

/// The affine function s -> offset + slope . s.
struct AffineFunction {
  double offset;
  Eigen::Vector3d slope;
};

/// The solution of a max-min programme.
struct MaxMinSolution {
  double value;           ///< the maximum
  Eigen::Vector3d point;  ///< where it is attained
  std::uint32_t binding;  ///< bit i is set if the value rests on function i
};

/// The most functions that maximise_minimum() takes.
inline constexpr int max_min_capacity = 32;

/// Maximises min_i f_i(s) over the box |s|_inf <= half_size: a linear programme in four variables,
/// solved by the simplex method with bounded variables. The value is an upper bound of the maximum
/// but for rounding, even where the iteration is cut short.
/// @pre 1 <= functions.size() <= max_min_capacity; half_size > 0; slopes of about unit length
MaxMinSolution maximise_minimum(std::span<const AffineFunction> functions, double half_size);

}  // namespace mdbd
