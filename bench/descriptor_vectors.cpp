#include "bench/descriptor_vectors.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <string>

#include "features/descriptor/fused_signature.h"
#include "tests/support/ball_clouds.h"

namespace mdbd {
namespace {

constexpr std::size_t half = 50;
constexpr std::size_t cluster_size = 20;
constexpr double cluster_spread = 0.2;  // of the standard deviation of the whole
constexpr float fused_spread = 0.5F;    // the largest share of a shape outside of the cluster

// The largest variances in the directions of the principal axes; each later one is the one before
// by a constant factor.
constexpr std::array radius_variances = {0.0603,  8.81e-3, 3.5e-3,  1.27e-3, 6.45e-4, 3.87e-4,
                                         2.32e-4, 1.38e-4, 1.02e-4, 8.02e-5, 5.43e-5, 3.79e-5};
constexpr std::array walk_variances = {0.043,   1.88e-4, 2.98e-5, 1.25e-5,
                                       1.48e-6, 5.7e-7,  1.14e-7, 3.3e-8};
constexpr double radius_decay = 0.85;
constexpr double walk_decay = 0.3;

using Half = std::array<double, half>;

Half deviations(std::span<const double> variances, double decay) {
  Half result{};
  double variance = 0.0;
  for (std::size_t i = 0; i < half; ++i) {
    variance = i < variances.size() ? variances[i] : variance * decay;
    result[i] = std::sqrt(variance);
  }
  return result;
}

/// The orthonormal cosine transform (DCT-III) of coordinates along its axes.
void append_transformed(const Half& coordinates, std::vector<float>& values) {
  static const std::array<Half, half> basis = [] {
    std::array<Half, half> rows{};
    for (std::size_t i = 0; i < half; ++i) {
      for (std::size_t axis = 0; axis < half; ++axis) {
        const double scale = std::sqrt((axis == 0 ? 1.0 : 2.0) / half);
        rows[i][axis] = scale * std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) *
                                         static_cast<double>(axis) / half);
      }
    }
    return rows;
  }();
  for (const Half& row : basis) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < half; ++axis) sum += row[axis] * coordinates[axis];
    values.push_back(static_cast<float>(sum));
  }
}

std::vector<float> blend(const std::vector<float>& left, const std::vector<float>& right,
                         float part) {
  std::vector<float> result(left.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    result[i] = (1.0F - part) * left[i] + part * right[i];
  }
  return result;
}

std::string name_of(std::size_t row) { return "/models/" + std::to_string(row) + ".off"; }

}  // namespace

VectorTable mdbd_100_vectors(std::size_t count) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const std::array<Half, 2> spreads = {deviations(radius_variances, radius_decay),
                                       deviations(walk_variances, walk_decay)};
  std::array<Half, 2> centre{};
  VectorTableBuilder vectors;
  for (std::size_t row = 0; row < count; ++row) {
    std::vector<float> values;
    for (std::size_t part = 0; part < 2; ++part) {
      Half member{};
      for (std::size_t i = 0; i < half; ++i) {
        if (row % cluster_size == 0) centre[part][i] = spreads[part][i] * normal(random);
        member[i] = centre[part][i] + cluster_spread * spreads[part][i] * normal(random);
      }
      append_transformed(member, values);
    }
    vectors.append({static_cast<std::int64_t>(row + 1), name_of(row), 1.0, values});
  }
  return vectors.take();
}

VectorTable mdbd_fused_vectors(std::size_t count) {
  constexpr std::size_t shapes = 1000;
  constexpr std::size_t balls = 40;
  std::vector<std::vector<float>> signatures;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-1.5, 1.5);
  for (unsigned seed = 0; seed < shapes; ++seed) {
    std::vector<Ball> cloud = test::random_balls(balls, seed);
    const Eigen::Vector3d stretch(std::exp(exponent(random)), std::exp(exponent(random)), 1.0);
    for (Ball& ball : cloud) ball.center = ball.center.cwiseProduct(stretch);
    signatures.push_back(compute_fused_signature(cloud));
  }
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  VectorTableBuilder vectors;
  std::vector<float> centre;
  for (std::size_t row = 0; row < count; ++row) {
    if (row % cluster_size == 0) {
      centre = blend(signatures[random() % shapes], signatures[random() % shapes], share(random));
    }
    const float part = fused_spread * share(random);
    const std::vector<float> values = blend(centre, signatures[random() % shapes], part);
    vectors.append({static_cast<std::int64_t>(row + 1), name_of(row), 1.0, values});
  }
  return vectors.take();
}

}  // namespace mdbd
