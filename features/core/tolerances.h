#pragma once

/// Every tolerance of the project that is not an option. Lengths are relative to R, the radius of
/// the smallest ball that encloses the shape, unless said otherwise.
namespace mdbd::tolerances {

/// How far a ball may leave the solid or enter another ball.
inline constexpr double containment = 1e-9;

}  // namespace mdbd::tolerances
