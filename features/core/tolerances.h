#pragma once

/// Every tolerance of the project that is not an option. Lengths are relative to R, the radius of
/// the smallest ball that encloses the shape, unless said otherwise.
namespace mdbd::tolerances {

/// How far a ball may leave the solid or enter another ball.
inline constexpr double containment = 1e-9;

/// Two radii that differ by less are the same radius: what single-precision files preserve when a
/// model is rotated.
inline constexpr double radius_tie = 1e-6;

}  // namespace mdbd::tolerances
