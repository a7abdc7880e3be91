#include "features/descriptor/fused_signature.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Eigenvalues>

#include "features/descriptor/solid_frame.h"

namespace mdbd {
namespace {

// The square root, as for comparing distributions (Hellinger), with a finite slope at zero: what is
// zero but for rounding must not become large.
std::vector<double> soft_roots(std::vector<double> values) {
  constexpr double softness = 1e-3;
  for (double& value : values) value = std::sqrt(value + softness) - std::sqrt(softness);
  return values;
}

std::vector<double> largest_radii(std::span<const Ball> balls, double scale) {
  std::vector<double> radii;
  radii.reserve(std::max(balls.size(), fused_radii));
  for (const Ball& ball : balls) radii.push_back(ball.radius / scale);
  std::ranges::sort(radii, std::greater<>());
  radii.resize(fused_radii, 0.0);
  return radii;
}

std::vector<double> log_axes(std::span<const Ball> balls) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double volume = 0.0;
  for (const Ball& ball : balls) {
    const double squared = ball.radius * ball.radius;
    const double weight = squared * ball.radius;
    moments += weight * (ball.center * ball.center.transpose());
    moments.diagonal().array() += weight * squared / 5;
    volume += weight;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments / volume,
                                                              Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& increasing = solver.eigenvalues();
  return {0.5 * std::log(increasing[2]), 0.5 * std::log(increasing[1]),
          0.5 * std::log(increasing[0])};
}

}  // namespace

std::vector<float> compute_fused_signature(std::span<const Ball> balls, double scale) {
  if (balls.empty()) return std::vector<float>(fused_size, 0.0F);
  const std::vector<Ball> solid = to_solid_frame(balls);
  const std::array<std::vector<double>, fused_parts.size()> values{
      soft_roots(ball_placement(solid)), soft_roots(solid_harmonics(solid)),
      soft_roots(pair_distances(solid)), largest_radii(balls, scale), log_axes(solid)};
  std::vector<float> signature;
  signature.reserve(fused_size);
  for (std::size_t part = 0; part < values.size(); ++part) {
    for (const double value : values[part]) {
      signature.push_back(static_cast<float>(fused_parts[part].weight * value));
    }
  }
  return signature;
}

std::array<double, fused_parts.size()> fused_part_distances(std::span<const float> f,
                                                            std::span<const float> g) {
  std::array<double, fused_parts.size()> distances{};
  for (std::size_t part = 0; part < distances.size(); ++part) {
    const std::size_t end = fused_parts[part].first + fused_parts[part].count;
    for (std::size_t i = fused_parts[part].first; i < end; ++i) {
      distances[part] += std::abs(static_cast<double>(f[i]) - static_cast<double>(g[i]));
    }
  }
  return distances;
}

}  // namespace mdbd
