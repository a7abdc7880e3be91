#pragma once

#include <Eigen/Core>

namespace mdbd {

/// A closed ball {x : |x - center| <= radius}. Object units.
struct Ball {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

}  // namespace mdbd
