#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "features/core/ball.h"

/// The bytes of vectors and balls in the database: the same on every machine.
/// - A vector is its numbers one after the other, each a little-endian IEEE 754 float32.
/// - Balls are x, y, z, r of each, in order of placement, each a little-endian IEEE 754 float64.
namespace mdbd {

using Blob = std::vector<std::byte>;

inline constexpr std::size_t bytes_per_float = 4;
inline constexpr std::size_t bytes_per_ball = 32;

Blob encode_floats(std::span<const float> values);
Blob encode_balls(std::span<const Ball> balls);

/// The inverse of encode_floats, to the bit.
/// @pre the number of bytes is a multiple of bytes_per_float
std::vector<float> decode_floats(std::span<const std::byte> bytes);

/// The inverse of encode_balls, to the bit.
/// @pre the number of bytes is a multiple of bytes_per_ball
std::vector<Ball> decode_balls(std::span<const std::byte> bytes);

}  // namespace mdbd
