#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

namespace mdbd {

/// The map x -> scale * rotation * x + translation.
struct Similarity {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< orthogonal; determinant -1: mirrors
  double scale = 1.0;                                      ///< above 0
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  bool mirrors() const { return rotation.determinant() < 0.0; }

  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const {
    return scale * (rotation * point) + translation;
  }

  Similarity inverse() const {
    const Eigen::Matrix3d back = rotation.transpose();
    return {back, 1.0 / scale, -(back * translation) / scale};
  }
};

/// First the inner map, then the outer one.
inline Similarity compose(const Similarity& outer, const Similarity& inner) {
  return {outer.rotation * inner.rotation, outer.scale * inner.scale, outer(inner.translation)};
}

}  // namespace mdbd
