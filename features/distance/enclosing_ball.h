#pragma once

#include <span>

#include <Eigen/Core>

#include "features/core/ball.h"

namespace mdbd {

/// The smallest ball that encloses a set of points (Welzl, Smallest enclosing disks, 1991), to a
/// relative 1e-12. Deterministic. Object units.
/// @pre points is not empty
Ball enclosing_ball(std::span<const Eigen::Vector3d> points);

}  // namespace mdbd
