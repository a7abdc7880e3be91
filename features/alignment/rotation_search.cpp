#include "features/alignment/rotation_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "features/alignment/trial_rotations.h"

namespace mdbd {
namespace {

constexpr std::size_t covering_rotations = 600;
constexpr std::size_t compared_balls = 60;
constexpr std::size_t most_motions = 12;
constexpr std::size_t polished_trials = 40;
// Radians.
constexpr double first_turn = 0.2;
constexpr double least_turn = 0.02;
constexpr double same_rotation = 0.1;

/// The centred, scaled and turned frame of the principal axes of the solid that balls fill.
Similarity to_principal_frame(std::span<const Ball> balls) {
  double volume = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const Ball& ball : balls) {
    const double weight = std::pow(ball.radius, 3);
    volume += weight;
    moment += weight * ball.center;
  }
  const Eigen::Vector3d centroid = moment / volume;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Ball& ball : balls) {
    const Eigen::Vector3d offset = ball.center - centroid;
    // A ball's own variance along each axis is 1/5 r².
    covariance += std::pow(ball.radius, 3) / volume *
                  (offset * offset.transpose() +
                   0.2 * ball.radius * ball.radius * Eigen::Matrix3d::Identity());
  }
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) *= -1.0;
  Similarity frame{.rotation = axes.transpose(), .scale = 1.0 / std::sqrt(covariance.trace())};
  frame.translation = -frame.scale * (frame.rotation * centroid);
  return frame;
}

/// Some balls of all sizes, in a frame.
std::vector<Ball> some_balls(std::span<const Ball> balls, const Similarity& frame) {
  const std::size_t stride = (balls.size() + compared_balls - 1) / compared_balls;
  std::vector<Ball> result;
  for (std::size_t i = 0; i < balls.size(); i += stride) {
    result.push_back({frame(balls[i].center), frame.scale * balls[i].radius});
  }
  return result;
}

/// Whether the angle between two rotations is small; false if one of them mirrors.
bool are_same(const Eigen::Matrix3d& left, const Eigen::Matrix3d& right) {
  return (left.transpose() * right).trace() > 1.0 + 2.0 * std::cos(same_rotation);
}

}  // namespace

RotationSearch::RotationSearch(std::span<const Ball> first, std::span<const Ball> second)
    : first_frame_(to_principal_frame(first)),
      second_frame_(to_principal_frame(second)),
      first_(some_balls(first, first_frame_)),
      second_(to_arrays(second, second_frame_)) {
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal();
  for (const Eigen::Matrix3d& rotation : trial_rotations(covering_rotations)) {
    for (const Eigen::Matrix3d& trial : {rotation, Eigen::Matrix3d(rotation * mirror)}) {
      trials_.push_back({misfit(trial), trial});
    }
  }
  std::ranges::stable_sort(trials_, {}, &Trial::misfit);
}

RotationSearch::BallArrays RotationSearch::to_arrays(std::span<const Ball> balls,
                                                     const Similarity& frame) {
  const auto size = static_cast<Eigen::Index>(balls.size());
  BallArrays arrays{Eigen::ArrayXf(size), Eigen::ArrayXf(size), Eigen::ArrayXf(size),
                    Eigen::ArrayXf(size)};
  for (Eigen::Index i = 0; i < size; ++i) {
    const Ball& ball = balls[static_cast<std::size_t>(i)];
    const Eigen::Vector3f center = frame(ball.center).cast<float>();
    arrays.x[i] = center.x();
    arrays.y[i] = center.y();
    arrays.z[i] = center.z();
    arrays.radius[i] = static_cast<float>(frame.scale * ball.radius);
  }
  return arrays;
}

/// How far turned balls of the first are from lying in balls of the second as deep as they should.
double RotationSearch::misfit(const Eigen::Matrix3d& rotation) const {
  double sum = 0.0;
  for (const Ball& ball : first_) {
    const Eigen::Vector3f center = (rotation * ball.center).cast<float>();
    const float depth =
        (second_.radius - ((second_.x - center.x()).square() + (second_.y - center.y()).square() +
                           (second_.z - center.z()).square())
                              .sqrt())
            .maxCoeff();
    sum += ball.radius * ball.radius * std::abs(ball.radius - depth);
  }
  return sum;
}

/// A pattern search with ever smaller turns about the axes.
RotationSearch::Trial RotationSearch::polish(Trial trial) const {
  for (double angle = first_turn; angle > least_turn; angle *= 0.5) {
    bool has_gained = true;
    while (has_gained) {
      has_gained = false;
      for (int way = 0; way < 6; ++way) {
        const Eigen::AngleAxisd turn(way < 3 ? angle : -angle, Eigen::Vector3d::Unit(way % 3));
        const Eigen::Matrix3d turned = turn * trial.rotation;
        const double value = misfit(turned);
        if (value >= trial.misfit) continue;
        trial = {value, turned};
        has_gained = true;
      }
    }
  }
  return trial;
}

std::vector<Similarity> RotationSearch::to_motions(std::vector<Trial> trials) const {
  std::ranges::stable_sort(trials, {}, &Trial::misfit);
  std::vector<Similarity> motions;
  for (std::size_t i = 0; i < std::min(trials.size(), most_motions); ++i) {
    motions.push_back(
        compose(second_frame_.inverse(), compose({.rotation = trials[i].rotation}, first_frame_)));
  }
  return motions;
}

std::vector<Similarity> RotationSearch::likely() const { return to_motions(trials_); }

std::vector<Similarity> RotationSearch::polished() const {
  std::vector<Trial> polished;
  for (const Trial& trial : std::span(trials_).first(polished_trials)) {
    const Trial result = polish(trial);
    const bool is_new = std::ranges::none_of(
        polished, [&](const Trial& other) { return are_same(result.rotation, other.rotation); });
    if (is_new) polished.push_back(result);
  }
  return to_motions(std::move(polished));
}

}  // namespace mdbd
