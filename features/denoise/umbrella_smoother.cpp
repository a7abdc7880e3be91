#include "features/denoise/umbrella_smoother.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace mdbd {
namespace {

constexpr int most_steps = 200;
constexpr double residual_reduction = 1e-4;

using Triplets = std::vector<Eigen::Triplet<double>>;

void add_umbrella(std::uint32_t vertex, const VertexNeighbours& neighbours,
                  std::span<const double> weights, Triplets& entries) {
  const auto openness = neighbours.openness_of(vertex);
  const bool is_border = std::ranges::count(openness, char{1}) > 0;
  const std::uint32_t begin = neighbours.begin[vertex];
  const std::uint32_t end = neighbours.begin[vertex + 1];
  const auto weight = [&](std::uint32_t i) {
    return is_border && neighbours.is_open[i] == 0 ? 0.0 : weights[i];
  };
  double sum = 0.0;
  for (std::uint32_t i = begin; i < end; ++i) sum += weight(i);
  if (!(sum > 0.0)) return;
  entries.emplace_back(vertex, vertex, 1.0);
  for (std::uint32_t i = begin; i < end; ++i) {
    if (weight(i) > 0.0) entries.emplace_back(vertex, neighbours.vertices[i], -weight(i) / sum);
  }
}

}  // namespace

UmbrellaSmoother::UmbrellaSmoother(const VertexNeighbours& neighbours,
                                   std::span<const double> weights) {
  Triplets entries;
  entries.reserve(neighbours.size() + neighbours.vertices.size());
  for (std::uint32_t v = 0; v < neighbours.size(); ++v)
    add_umbrella(v, neighbours, weights, entries);
  const auto size = static_cast<Eigen::Index>(neighbours.size());
  umbrella_.resize(size, size);
  umbrella_.setFromTriplets(entries.begin(), entries.end());
  transposed_ = umbrella_.transpose();
  column_squares_ = umbrella_.cwiseProduct(umbrella_).transpose() * Eigen::VectorXd::Ones(size);
}

Positions UmbrellaSmoother::smooth(const Positions& noisy, double strength,
                                   const Positions& start) const {
  const auto apply = [&](const Positions& x) -> Positions {
    const Positions offsets = umbrella_ * x;
    return x + strength * (transposed_ * offsets);
  };
  const auto dot = [](const Positions& a, const Positions& b) { return a.cwiseProduct(b).sum(); };
  const Eigen::VectorXd scaling = (1.0 + strength * column_squares_.array()).inverse();

  Positions x = start;
  Positions residual = noisy - apply(x);
  Positions scaled = scaling.asDiagonal() * residual;
  Positions direction = scaled;
  double product = dot(residual, scaled);
  const double enough = residual_reduction * residual_reduction * product;
  for (int step = 0; step < most_steps && product > enough; ++step) {
    const Positions image = apply(direction);
    const double length = product / dot(direction, image);
    x += length * direction;
    residual -= length * image;
    scaled = scaling.asDiagonal() * residual;
    const double next = dot(residual, scaled);
    direction = scaled + next / product * direction;
    product = next;
  }
  return x;
}

double UmbrellaSmoother::response(double strength) {
  constexpr int samples = 64;
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    for (int j = 0; j < samples; ++j) {
      const double a = 2 * std::numbers::pi * (i + 0.5) / samples;
      const double b = 2 * std::numbers::pi * (j + 0.5) / samples;
      const double eigenvalue = 1 - (std::cos(a) + std::cos(b) + std::cos(a + b)) / 3;
      sum += 1 / (1 + strength * eigenvalue * eigenvalue);
    }
  }
  return sum / (samples * samples);
}

}  // namespace mdbd
