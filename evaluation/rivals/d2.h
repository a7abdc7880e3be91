#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// How many numbers D2 has, how far they reach in means, and of how many pairs of points they are
/// made.
inline constexpr std::size_t d2_bins = 64;
inline constexpr int d2_range = 3;
inline constexpr std::size_t d2_pairs = std::size_t{1024} * 1024;

/// The shape distribution D2 (Osada, Funkhouser, Chazelle, Dobkin, Shape Distributions, ACM
/// Transactions on Graphics 21(4), 2002): the distribution of the distance of two random points of
/// the surface, as a histogram over [0, 3) times its mean that sums to 1. Pairs further apart, at
/// most one in three, count in the last bin.
/// @throws InvalidInput as sample_surface
std::vector<float> compute_d2(const TriangleMesh& mesh, std::uint64_t seed);

}  // namespace mdbd
