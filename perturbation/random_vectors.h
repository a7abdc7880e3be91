#pragma once

#include <Eigen/Geometry>

#include "features/core/random.h"

namespace mdbd {

/// A random vector, uniform in the unit ball.
Eigen::Vector3d random_in_unit_ball(Random& random);

/// A random unit vector, uniform on the sphere.
Eigen::Vector3d random_direction(Random& random);

/// A random rotation, uniform among all rotations (Shoemake, Uniform random rotations, Graphics
/// Gems III, 1992).
Eigen::Quaterniond random_rotation(Random& random);

}  // namespace mdbd
