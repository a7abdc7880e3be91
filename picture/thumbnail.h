#pragma once

#include <span>
#include <string>

#include "features/core/ball.h"
#include "features/shape.h"

/// Small pictures of shapes for pages and lists: PNG files of thumbnail_size squared pixels on a
/// transparent ground, seen obliquely from above, with the file's z upwards, and filling the
/// picture. Drawn in memory, the same bytes on every run.
namespace mdbd {

inline constexpr int thumbnail_size = 160;

/// The surface of a shape or, of a representation that has none at hand, its balls.
/// @returns an empty string if there is nothing to be seen
std::string draw_thumbnail(const VisibleSurface& surface, std::span<const Ball> balls);

/// As draw_thumbnail() of the balls alone.
std::string draw_balls(std::span<const Ball> balls);

}  // namespace mdbd
