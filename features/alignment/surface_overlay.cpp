#include "features/alignment/surface_overlay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace mdbd {
namespace {

// A small motion: a rotation vector, a translation and the logarithm of a scale.
using Step = Eigen::Matrix<double, 7, 1>;
using NormalMatrix = Eigen::Matrix<double, 7, 7>;

constexpr int most_steps = 20;
constexpr double first_damping = 1e-3;
constexpr double least_damping = 1e-6;
constexpr double largest_damping = 1e3;
constexpr double worthwhile_gain = 1e-3;  // of the sum of squares
constexpr double negligible_error = 1e-10;

/// A direction for each number; together they cover the sphere evenly (the R2 sequence of Roberts,
/// which generalises the golden ratio).
Eigen::Vector3d direction(std::size_t number) {
  const double n = static_cast<double>(number);
  const double z = 2.0 * std::fmod(0.5 + n * 0.7548776662466927, 1.0) - 1.0;
  const double angle = 2.0 * std::numbers::pi * n * 0.5698402909980532;
  const double width = std::sqrt(1.0 - z * z);
  return {width * std::cos(angle), width * std::sin(angle), z};
}

std::vector<DistanceSample> measure_all(const DistanceField& field,
                                        const std::vector<DistanceQuery>& queries) {
  std::vector<DistanceSample> samples(queries.size());
  field.measure(queries, samples);
  return samples;
}

/// Asks for the boundary at the two ends of balls: they show all that balls fill.
void append_ends_of_balls(const PackedShape& shape, std::size_t balls,
                          std::vector<DistanceQuery>& queries) {
  const std::size_t stride = (shape.balls.size() + balls - 1) / balls;
  for (std::size_t i = 0; i < shape.balls.size(); i += stride) {
    const Ball& ball = shape.balls[i];
    const Eigen::Vector3d radius = ball.radius * direction(i);
    queries.push_back({.point = ball.center + radius});
    queries.push_back({.point = ball.center - radius});
  }
}

/// Asks for the boundary nearest to points all over the enclosing ball: it shows what sticks out,
/// though it may be too thin for any of the balls.
void append_surroundings(const PackedShape& shape, std::size_t count,
                         std::vector<DistanceQuery>& queries) {
  const Ball enclosing = shape.field.enclosing_ball();
  for (std::size_t i = 0; i < count; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    queries.push_back(
        {.point = enclosing.center + enclosing.radius * std::cbrt(share) * direction(i)});
  }
}

std::vector<Eigen::Vector3d> boundary_points(const PackedShape& shape, std::size_t balls) {
  std::vector<DistanceQuery> queries;
  append_ends_of_balls(shape, balls, queries);
  append_surroundings(shape, 2 * balls, queries);
  std::vector<Eigen::Vector3d> points;
  for (const DistanceSample& sample : measure_all(shape.field, queries)) {
    points.push_back(sample.closest);
  }
  return points;
}

double sum_of_squares(const std::vector<PointError>& errors) {
  double sum = 0.0;
  for (const PointError& error : errors) sum += error.error * error.error;
  return sum;
}

Eigen::Matrix3d rotation_by(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

}  // namespace

SurfaceOverlay::SurfaceOverlay(const PackedShape& first, const PackedShape& second,
                               std::size_t balls)
    : first_(first),
      second_(second),
      unit_(second.field.enclosing_ball()),
      first_points_(boundary_points(first, balls)),
      second_points_(boundary_points(second, balls)) {}

std::vector<PointError> SurfaceOverlay::measure(const Similarity& motion) const {
  std::vector<PointError> errors;
  errors.reserve(first_points_.size() + second_points_.size());
  measure_first(motion, errors);
  measure_second(motion, errors);
  return errors;
}

void SurfaceOverlay::measure_first(const Similarity& motion,
                                   std::vector<PointError>& errors) const {
  std::vector<DistanceQuery> queries;
  for (const Eigen::Vector3d& point : first_points_) queries.push_back({.point = motion(point)});
  const std::vector<DistanceSample> samples = measure_all(second_.field, queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Eigen::Vector3d offset = queries[i].point - samples[i].closest;
    const double error = std::max(offset.norm() - second_.resolution, 0.0) / unit_.radius;
    errors.push_back({queries[i].point, offset.normalized(), error});
  }
}

void SurfaceOverlay::measure_second(const Similarity& motion,
                                    std::vector<PointError>& errors) const {
  const Similarity back = motion.inverse();
  std::vector<DistanceQuery> queries;
  for (const Eigen::Vector3d& point : second_points_) queries.push_back({.point = back(point)});
  const std::vector<DistanceSample> samples = measure_all(first_.field, queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Eigen::Vector3d offset = queries[i].point - samples[i].closest;
    const double distance = std::max(offset.norm() - first_.resolution, 0.0);
    errors.push_back({second_points_[i], -(motion.rotation * offset).normalized(),
                      motion.scale * distance / unit_.radius});
  }
}

/// One step of Levenberg and Marquardt.
Similarity SurfaceOverlay::step(const Similarity& motion, const std::vector<PointError>& errors,
                                double damping) const {
  NormalMatrix matrix = NormalMatrix::Zero();
  Step side = Step::Zero();
  for (const PointError& error : errors) {
    const Eigen::Vector3d point = (error.point - unit_.center) / unit_.radius;
    Step slope;
    slope << point.cross(error.gradient), error.gradient, point.dot(error.gradient);
    matrix.selfadjointView<Eigen::Lower>().rankUpdate(slope);
    side -= error.error * slope;
  }
  matrix.diagonal().array() += damping * matrix.trace();
  const Step solution = matrix.selfadjointView<Eigen::Lower>().ldlt().solve(side);
  Similarity change{.rotation = rotation_by(solution.head<3>()), .scale = std::exp(solution(6))};
  change.translation = unit_.center + unit_.radius * solution.segment<3>(3) -
                       change.scale * (change.rotation * unit_.center);
  return compose(change, motion);
}

Similarity SurfaceOverlay::refine(const Similarity& motion) const {
  Similarity best = motion;
  std::vector<PointError> errors = measure(best);
  double squares = sum_of_squares(errors);
  double damping = first_damping;
  for (int i = 0; i < most_steps && damping < largest_damping; ++i) {
    if (largest_error(errors) < negligible_error) break;
    const Similarity next = step(best, errors, damping);
    std::vector<PointError> next_errors = measure(next);
    const double next_squares = sum_of_squares(next_errors);
    if (!(next_squares < squares)) {
      damping *= 10.0;
      continue;
    }
    const bool is_settled = next_squares > (1.0 - worthwhile_gain) * squares;
    best = next;
    errors = std::move(next_errors);
    squares = next_squares;
    damping = std::max(0.1 * damping, least_damping);
    if (is_settled) break;
  }
  return best;
}

double largest_error(const std::vector<PointError>& errors) {
  double largest = 0.0;
  for (const PointError& error : errors) largest = std::max(largest, error.error);
  return largest;
}

}  // namespace mdbd
