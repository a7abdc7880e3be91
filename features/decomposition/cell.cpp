#include "features/decomposition/cell.h"

#include <algorithm>
#include <cmath>

namespace mdbd {

Cell::Cell(const Eigen::Vector3d& center, double half_size, double bound)
    : center_(center), half_size_(half_size), bound_(bound) {
  witnesses_.fill({Eigen::Vector3d::Zero()});
}

double Cell::half_diagonal() const { return std::sqrt(3.0) * half_size_; }

// In a cell that is large for its balls a division helps more than another boundary point, but at
// the boundary it helps to know how empty the outside is.
Cell::Probe Cell::next_probe() const {
  if (half_size_ > 0.35 * bound_) {
    const bool at_boundary = std::abs(distance_) < half_diagonal() && half_size_ < 4.0 * bound_;
    return probes_ == 0 && at_boundary ? Probe::outward : Probe::none;
  }
  const std::uint8_t most = half_size_ > 0.2 * bound_ ? 1 : 2;
  if (probes_ >= most) return Probe::none;
  return probes_ == 0 && distance_ > 0 ? Probe::across : Probe::peak;
}

void Cell::tighten(const RemainingSpace& space, double enough) {
  const std::uint32_t first_new = balls_seen_;
  if (!find_nearby_balls(space) && is_solved_) return;
  for (std::size_t i = 0; i < nearby_count_; ++i) {
    if (nearby_[i] >= first_new) limit_by(space.balls().witness(nearby_[i]), space);
  }
  solve(space, enough);
}

void Cell::limit_by(const Witness& ball, const RemainingSpace& space) {
  limit((reach(ball.center) - ball.radius) *
        space.preference().largest_factor(center_, half_size_));
}

void Cell::tighten(const CubeBounds& bounds, double enough) {
  binding_ = 0;
  peak_.setZero();
  limit(bounds.smallest);
  is_solved_ = bound_ > enough;
  if (!is_solved_) return;
  std::array<AffineFunction, WitnessLanes::capacity> functions;
  std::array<std::uint8_t, WitnessLanes::capacity> origin;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < bounds.count; ++i) {
    const AffineFunction f{bounds.offset[i],
                           {bounds.slope[0][i], bounds.slope[1][i], bounds.slope[2][i]}};
    origin[kept] = static_cast<std::uint8_t>(i);
    functions[kept] = f;
    // What is nowhere below the bound says nothing.
    kept += f.offset - half_size_ * f.slope.lpNorm<1>() < bound_ ? 1 : 0;
  }
  if (kept == 0) return;
  const MaxMinSolution solution = maximise_minimum({functions.data(), kept}, half_size_);
  limit(solution.value);
  peak_ = (solution.point / half_size_).cast<float>();
  unsigned binding = 0;  // the placed balls, too
  for (std::size_t i = 0; i < kept; ++i) binding |= (solution.binding >> i & 1U) << origin[i];
  binding_ = static_cast<std::uint8_t>(binding & ((1U << witness_count_) - 1U));
}

WitnessLanes Cell::witnesses(const RemainingSpace& space) const {
  WitnessLanes lanes;
  for (std::size_t i = 0; i < witness_count_; ++i) lanes.add(witnesses_[i]);
  for (std::size_t i = 0; i < nearby_count_; ++i) lanes.add(space.balls().witness(nearby_[i]));
  return lanes;
}

void Cell::solve(const RemainingSpace& space, double enough) {
  is_solved_ = bound_ > enough;
  if (!is_solved_) return;
  const WitnessLanes lanes = witnesses(space);
  if (lanes.count > 0) {
    tighten(bound_over_cube(lanes, space.preference(), center_, half_size_), enough);
  }
}

bool Cell::find_nearby_balls(const RemainingSpace& space) {
  const BallSet& balls = space.balls();
  const double limit = bound_ + half_diagonal();
  if (!balls.has_near(center_, limit, balls_seen_)) {
    balls_seen_ = static_cast<std::uint32_t>(balls.size());
    return false;
  }
  const auto old = nearby_;
  const std::uint8_t old_count = nearby_count_;
  nearby_count_ = static_cast<std::uint8_t>(
      balls.update_nearest(center_, limit, balls_seen_, nearby_, nearby_count_));
  balls_seen_ = static_cast<std::uint32_t>(balls.size());
  if (nearby_count_ > 0) value_ = std::min(value_, balls.witness(nearby_[0]).value(center_));
  return nearby_count_ != old_count ||
         !std::equal(old.begin(), old.begin() + old_count, nearby_.begin());
}

DistanceQuery Cell::make_query(const RemainingSpace& space, const Eigen::Vector3d& point) const {
  DistanceQuery query{.point = point};
  double least_gap = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Eigen::Vector3d& center, double distance) {
    const double gap = (point - center).norm() - std::abs(distance);
    if (gap >= least_gap) return;
    least_gap = gap;
    query.neighbour = center;
    query.neighbour_distance = distance;
  };
  if (space.is_closed()) offer(measured_, distance_);
  for (std::size_t i = 0; i < witness_count_; ++i) {
    // The boundary passes through every witness, be it a point or a ball outside.
    const Witness& witness = witnesses_[i];
    const double distance = (point - witness.center).norm() + witness.radius;
    query.bound = std::min(query.bound, distance);
    if (space.is_closed() && witness.radius > 0) offer(witness.center, -witness.radius);
  }
  return query;
}

void Cell::measure(RemainingSpace& space, double enough) {
  const DistanceSample sample = space.measure_solid(make_query(space, center_));
  is_measured_ = true;
  measured_ = center_;
  distance_ = sample.distance;
  value_ = sample.distance;
  balls_seen_ = 0;  // what was inherited may not be the nearest balls
  nearby_count_ = 0;
  limit((distance_ + half_diagonal()) * space.preference().largest_factor(center_, half_size_));
  find_nearby_balls(space);
  if (witness_count_ == 0) {
    witness_count_ = 1;
  } else {
    add_witness(witnesses_[0]);
  }
  witnesses_[0] = space.simple_witness_of(sample);
  solve(space, enough);
}

std::pair<Eigen::Vector3d, double> Cell::probe(RemainingSpace& space, double enough) {
  const Eigen::Vector3d point = space.in_domain(probe_point());
  ++probes_;
  const DistanceSample sample = space.measure_solid(make_query(space, point));
  // The ball around a point outside up to the boundary holds nothing of the solid.
  add_witness(sample.distance < 0 ? Witness{point, -sample.distance}
                                  : space.simple_witness_of(sample));
  solve(space, enough);
  double value = sample.distance;
  for (std::size_t i = 0; i < nearby_count_; ++i) {
    value = std::min(value, space.balls().witness(nearby_[i]).value(point));
  }
  return {point, value};
}

Eigen::Vector3d Cell::probe_point() const {
  const Eigen::Vector3d from_boundary = (center_ - witnesses_[0].center).normalized();
  switch (next_probe()) {
    case Probe::outward: {
      const double sign = distance_ > 0 ? -1.0 : 1.0;
      return witnesses_[0].center + sign * 6.0 * half_size_ * from_boundary;
    }
    case Probe::across:
      // Beyond any medial sheet in the cell: the two witnesses then face each other exactly.
      return center_ + 1.5 * half_size_ * from_boundary;
    case Probe::peak:
    case Probe::none:
      break;
  }
  return center_ + half_size_ * peak_.cast<double>();
}

// If there is no room the witness takes the place of the farthest on which the bound does not rest;
// the first, which belongs to the centre, stays.
void Cell::add_witness(const Witness& witness) {
  if (witness_count_ < kept_witnesses) {
    witnesses_[witness_count_++] = witness;
    return;
  }
  std::size_t replaced = 1;
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < kept_witnesses; ++i) {
    const double distance = (center_ - witnesses_[i].center).norm() - witnesses_[i].radius;
    if ((binding_ >> i & 1U) != 0 || distance <= farthest) continue;
    replaced = i;
    farthest = distance;
  }
  witnesses_[replaced] = witness;
}

Cell Cell::child(int octant) const { return divided(octant, 3); }

Cell Cell::planar_child(int quadrant) const { return divided(quadrant, 2); }

Cell Cell::divided(int part, int axes) const {
  Cell child = *this;
  child.half_size_ = 0.5 * half_size_;
  for (int axis = 0; axis < axes; ++axis) {
    child.center_[axis] += (2 * (part >> axis & 1) - 1) * child.half_size_;
  }
  child.is_measured_ = false;
  child.probes_ = 0;
  child.is_solved_ = false;
  return child;
}

double Cell::reach(const Eigen::Vector3d& from) const {
  return ((center_ - from).cwiseAbs().array() + half_size_).matrix().norm();
}

}  // namespace mdbd
