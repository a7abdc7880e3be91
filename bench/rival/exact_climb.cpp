#include "bench/rival/exact_climb.h"

#include <algorithm>
#include <limits>

namespace mdbd::bench {
namespace {

// Steps end when they are as short as this, relative to the radius: a third of what counts as a
// contact.
constexpr double last_step = 3e-4;
constexpr double decay = 0.5;
// How many directions are tried with one length of a step.
constexpr int most_tries = 8;
// Where the steepest ascent is flatter than this, steps of this length lead nowhere.
constexpr double flat = 0.05;
// Warm starts are rounded up.
constexpr double rounding = 1.0 + 1e-12;

// The point of the segment from a to b that is nearest to the origin.
Eigen::Vector3d nearest_to_origin(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d ab = b - a;
  const double length = ab.squaredNorm();
  return length > 0 ? Eigen::Vector3d(a + std::clamp(-a.dot(ab) / length, 0.0, 1.0) * ab) : a;
}

}  // namespace

double ExactClimb::measure(const Eigen::Vector3d& inside) {
  return query({.point = inside, .side = Side::inside}).distance;
}

Ball ExactClimb::climb(const Eigen::Vector3d& inside, double step) {
  const DistanceSample sample = query({.point = inside, .side = Side::inside});
  gather_neighbours(inside, 3.0 * (sample.distance + step));
  Place place = make_place(inside, sample, nearest_ball(inside, sample.distance));
  while (step > last_step * std::max(place.radius, smallest_)) {
    if (const auto next = find_step(place, step)) {
      place = *next;
    } else {
      step *= decay;
    }
  }
  return {place.point, place.radius};
}

// A place of a larger ball at some distance.
std::optional<ExactClimb::Place> ExactClimb::find_step(const Place& from, double length) {
  Eigen::Vector3d direction = from.away;
  for (int i = 0; i < most_tries; ++i) {
    const double steepness = direction.norm();
    if (steepness < flat) break;
    const Place place = look(from, length / steepness * direction);
    if (place.radius > from.radius) return place;
    direction = nearest_to_origin(direction, place.away);
  }
  return std::nullopt;
}

ExactClimb::Place ExactClimb::look(const Place& from, const Eigen::Vector3d& step) {
  const Eigen::Vector3d point = from.point + step;
  const double length = step.norm();
  const Gap gap = nearest_ball(point, from.sample.distance + length);
  if (gap.distance <= from.radius) {  // the boundary does not matter
    return {point, gap.distance, (point - gap.center).normalized(), {}};
  }
  const DistanceQuery next{.point = point,
                           .neighbour = from.point,
                           .neighbour_distance = from.sample.distance,
                           .bound = (point - from.sample.closest).norm() * rounding};
  return make_place(point, query(next), gap);
}

ExactClimb::Place ExactClimb::make_place(const Eigen::Vector3d& point, const DistanceSample& sample,
                                         const Gap& gap) {
  if (gap.distance < sample.distance) {
    return {point, gap.distance, (point - gap.center).normalized(), sample};
  }
  const double sign = sample.distance < 0 ? -1.0 : 1.0;
  return {point, sample.distance, sign * (point - sample.closest).normalized(), sample};
}

DistanceSample ExactClimb::query(const DistanceQuery& query) {
  ++query_count_;
  return field_.measure(query);
}

// The nearest ball; or some ball farther than `limit`, or none, if no ball is nearer than that.
ExactClimb::Gap ExactClimb::nearest_ball(const Eigen::Vector3d& point, double limit) {
  if ((point - gathered_at_).norm() + limit > reach_) gather_neighbours(point, 2.0 * limit);
  Gap nearest{std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero()};
  for (const Ball& ball : neighbours_) {
    const double distance = (point - ball.center).norm() - ball.radius;
    if (distance < nearest.distance) nearest = {distance, ball.center};
  }
  return nearest;
}

void ExactClimb::gather_neighbours(const Eigen::Vector3d& point, double reach) {
  neighbours_.clear();
  for (const Ball& ball : balls_) {
    const double limit = ball.radius + reach;
    if ((ball.center - point).squaredNorm() < limit * limit) neighbours_.push_back(ball);
  }
  gathered_at_ = point;
  reach_ = reach;
}

}  // namespace mdbd::bench
