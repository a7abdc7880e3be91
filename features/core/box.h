#pragma once

#include <Eigen/Geometry>

namespace mdbd {

/// An axis-aligned box. Object units.
using Box = Eigen::AlignedBox3d;

}  // namespace mdbd
