#include "features/decomposition/local_maximum.h"

#include <algorithm>
#include <array>
#include <limits>

#include <Eigen/Geometry>

namespace mdbd {
namespace {

constexpr int max_steps = 100;
constexpr std::size_t remembered_witnesses = 24;
constexpr std::size_t nearby_balls = 8;
static_assert(remembered_witnesses + nearby_balls <= max_min_capacity);

class Ascent {
 public:
  Ascent(RemainingSpace& space, const Eigen::Vector3d& start, double step, double precision)
      : space_(space), x_(start), step_(step), precision_(precision) {
    radius_ = measure({.point = start, .side = Side::inside});
    find_nearby_balls();
  }

  LocalMaximum run() {
    for (int i = 0; i < max_steps; ++i) {
      // A tessellated surface mostly goes on beyond a face as if the face did.
      MaxMinSolution promised = maximise_minimum(models(step_), step_);
      if (promised.value - rank() <= precision_) promised = maximise_minimum(models(0.0), step_);
      const double gain = promised.value - rank();
      if (gain <= precision_) break;
      try_point(space_.in_domain(x_ + promised.point), gain);
    }
    return {{x_, radius_}, rank(), basin_radius()};
  }

 private:
  double rank() const { return radius_ * space_.preference().factor(x_); }

  double measure(const DistanceQuery& query) {
    const Eigen::Vector3d& point = query.point;
    const DistanceSample sample = space_.measure_solid(query);
    boundary_point_ = sample.closest;
    remember(space_.witness_of(sample));
    double value = sample.distance;
    std::array<std::uint32_t, 1> nearest;
    if (space_.balls().find_nearest(point, value, nearest) > 0) {
      const Witness ball = space_.balls().witness(nearest[0]);
      value = ball.value(point);
      remember(ball);
    }
    return value;
  }

  void remember(const Witness& witness) {
    const auto is_same = [&](const Witness& known) {
      return witness.piece != nullptr ? known.piece == witness.piece
                                      : known.center == witness.center;
    };
    const auto end = witnesses_.begin() + static_cast<std::ptrdiff_t>(remembered());
    if (std::find_if(witnesses_.begin(), end, is_same) != end) return;
    witnesses_[witness_count_++ % remembered_witnesses] = witness;
  }

  void find_nearby_balls() {
    // A step changes no distance by more than its length, and none is longer than twice its size.
    const double reach = radius_ + 4.0 * step_;
    std::array<std::uint32_t, nearby_balls> nearest;
    nearby_count_ = space_.balls().find_nearest(x_, reach, nearest);
    for (std::size_t i = 0; i < nearby_count_; ++i) {
      nearby_[i] = space_.balls().witness(nearest[i]);
    }
  }

  std::size_t remembered() const { return std::min(witness_count_, remembered_witnesses); }

  std::span<const AffineFunction> models(double margin) {
    std::size_t count = 0;
    const auto add = [&](const Witness& witness) {
      models_[count++] = space_.preference().apply(witness.linearise(x_, margin), x_);
    };
    std::for_each_n(witnesses_.begin(), remembered(), add);
    std::for_each_n(nearby_.begin(), nearby_count_, add);
    return {models_.data(), count};
  }

  void try_point(const Eigen::Vector3d& point, double promised_gain) {
    const double radius =
        measure({.point = point,
                 .neighbour = x_,
                 .neighbour_distance = space_.is_closed() ? std::max(radius_, 0.0) : 0.0,
                 .bound = (point - boundary_point_).norm()});
    const double gain = radius * space_.preference().factor(point) - rank();
    if (gain < 0.25 * promised_gain) {
      step_ = 0.5 * std::min(step_, (point - x_).lpNorm<Eigen::Infinity>());
    } else if (gain > 0.75 * promised_gain) {
      step_ = std::min(2.0 * step_, radius_);
    }
    if (gain <= 0) return;
    x_ = point;
    radius_ = radius;
    find_nearby_balls();
  }

  // Near the ball the witnesses that touch it bound the rank by v - strength |s| + |s|^2 / (2 v).
  double basin_radius() {
    std::array<Eigen::Vector3d, max_min_capacity + 2> directions;
    std::size_t count = 0;
    for (const AffineFunction& model : models(0.0)) {
      if (model.offset <= rank() * (1.0 + contact_accuracy)) directions[count++] = model.slope;
    }
    if (space_.is_planar()) {
      directions[count++] = Eigen::Vector3d::UnitZ();
      directions[count++] = -Eigen::Vector3d::UnitZ();
    }
    return 2.0 * radius_ * hold_strength({directions.data(), count});
  }

  RemainingSpace& space_;
  Eigen::Vector3d x_;
  double radius_ = 0.0;             // d_i at x_
  Eigen::Vector3d boundary_point_;  // closest to the point that was measured last
  double step_;
  double precision_;
  std::array<Witness, remembered_witnesses> witnesses_;
  std::size_t witness_count_ = 0;
  std::array<Witness, nearby_balls> nearby_;
  std::size_t nearby_count_ = 0;
  std::array<AffineFunction, max_min_capacity> models_;
};

}  // namespace

LocalMaximum find_local_maximum(RemainingSpace& space, const Eigen::Vector3d& start, double step,
                                double precision) {
  return Ascent(space, start, step, precision).run();
}

// The least distance of a facet's plane from the origin, over all facets of the hull.
double hold_strength(std::span<const Eigen::Vector3d> directions) {
  constexpr double rounding = 1e-9;
  double strength = std::numeric_limits<double>::infinity();
  const std::size_t n = directions.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        Eigen::Vector3d normal =
            (directions[j] - directions[i]).cross(directions[k] - directions[i]);
        const double length = normal.norm();
        if (length < rounding) continue;
        normal /= length;
        double lowest = 0.0;
        double highest = 0.0;
        for (const Eigen::Vector3d& direction : directions) {
          const double height = normal.dot(direction - directions[i]);
          lowest = std::min(lowest, height);
          highest = std::max(highest, height);
        }
        const double offset = normal.dot(directions[i]);
        if (highest <= rounding) strength = std::min(strength, offset);
        if (lowest >= -rounding) strength = std::min(strength, -offset);
      }
    }
  }
  return std::isfinite(strength) ? std::max(0.0, strength) : 0.0;
}

}  // namespace mdbd
