#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "features/core/ball.h"
#include "features/descriptor/soft_bins.h"

/// The shape of the solid that the balls fill, seen from its centroid.
namespace mdbd {

/// The radii of the spheres around the origin between which the solid is shared …
inline constexpr int solid_shells = 8;
inline constexpr SoftBins solid_shell_nodes{0.3, 2.4, solid_shells};
/// … and the highest degree of the harmonics on each.
inline constexpr int solid_degree = 6;

inline constexpr std::size_t solid_size = std::size_t{solid_shells} * (solid_degree + 1);

/// Spherical-harmonic amplitudes of the solid in soft shells (after Kazhdan, Funkhouser,
/// Rusinkiewicz, Rotation Invariant Spherical Harmonic Representation of 3D Shape Descriptors, SGP
/// 2003, which takes the surface on a grid). A ball cuts a sphere around the origin in a cap, whose
/// harmonics are known in closed form; they are integrated over the radius of the sphere, weighted
/// by a hat function for each shell, to about 1e-6. Disjoint balls add up; the amplitude of a
/// degree is the root of its energy, relative to the volume of all balls. Continuous in the balls;
/// no rotation or reflection changes it.
/// @param balls in the frame of to_solid_frame(), disjoint
/// @returns at [s * (solid_degree + 1) + l] the amplitude of degree l in shell s; for l = 0 it is
///          the shell's share of the volume
std::vector<double> solid_harmonics(std::span<const Ball> balls);

}  // namespace mdbd
