#pragma once

#include <algorithm>
#include <cmath>

#include "features/distance/distance_field.h"

/// Distance fields of shapes with closed-form answers.
namespace mdbd::test {

/// A field given by a closest boundary point and a side.
class AnalyticField : public DistanceField {
 public:
  using DistanceField::measure;
  bool is_closed() const override { return true; }
  void measure(std::span<const DistanceQuery> queries,
               std::span<DistanceSample> samples) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Eigen::Vector3d& x = queries[i].point;
      const Eigen::Vector3d closest = closest_point(x);
      const double distance = (x - closest).norm();
      samples[i] = {.distance = contains(x) ? distance : -distance, .closest = closest};
    }
  }

 protected:
  virtual Eigen::Vector3d closest_point(const Eigen::Vector3d& x) const = 0;
  virtual bool contains(const Eigen::Vector3d& x) const = 0;
};

/// The ball of radius 1 around the origin.
class UnitBallField final : public AnalyticField {
 public:
  Ball enclosing_ball() const override { return {Eigen::Vector3d::Zero(), 1.0}; }

 protected:
  Eigen::Vector3d closest_point(const Eigen::Vector3d& x) const override {
    return x.norm() > 0 ? x.normalized() : Eigen::Vector3d::UnitX();
  }
  bool contains(const Eigen::Vector3d& x) const override { return x.norm() < 1.0; }
};

/// The box of the given half sizes around the origin.
class BoxField final : public AnalyticField {
 public:
  explicit BoxField(const Eigen::Vector3d& half) : half_(half) {}
  Ball enclosing_ball() const override { return {Eigen::Vector3d::Zero(), half_.norm()}; }

 protected:
  Eigen::Vector3d closest_point(const Eigen::Vector3d& x) const override {
    Eigen::Vector3d closest = x.cwiseMax(-half_).cwiseMin(half_);
    if (!contains(x)) return closest;
    int axis = 0;
    (half_ - x.cwiseAbs()).minCoeff(&axis);
    closest[axis] = x[axis] < 0 ? -half_[axis] : half_[axis];
    return closest;
  }
  bool contains(const Eigen::Vector3d& x) const override {
    return (half_ - x.cwiseAbs()).minCoeff() > 0;
  }

 private:
  Eigen::Vector3d half_;
};

/// The torus around the z axis with the given radii.
class TorusField final : public AnalyticField {
 public:
  TorusField(double major, double minor) : major_(major), minor_(minor) {}
  Ball enclosing_ball() const override { return {Eigen::Vector3d::Zero(), major_ + minor_}; }

 protected:
  Eigen::Vector3d closest_point(const Eigen::Vector3d& x) const override {
    const Eigen::Vector3d core = core_point(x);
    const Eigen::Vector3d offset = x - core;
    if (!(offset.norm() > 0)) return core + minor_ * Eigen::Vector3d::UnitZ();
    return core + minor_ * offset.normalized();
  }
  bool contains(const Eigen::Vector3d& x) const override {
    return (x - core_point(x)).norm() < minor_;
  }

 private:
  Eigen::Vector3d core_point(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d flat(x.x(), x.y(), 0.0);
    return flat.norm() > 0 ? Eigen::Vector3d(major_ * flat.normalized())
                           : Eigen::Vector3d(major_, 0.0, 0.0);
  }

  double major_;
  double minor_;
};

}  // namespace mdbd::test
