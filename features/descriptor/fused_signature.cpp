#include "features/descriptor/fused_signature.h"

#include <cmath>

#include "features/descriptor/solid_frame.h"

namespace mdbd {
namespace {

// The square root, as for comparing distributions (Hellinger), with a finite slope at zero: what is
// zero but for rounding must not become large.
double soft_root(double value) {
  constexpr double softness = 1e-3;
  return std::sqrt(value + softness) - std::sqrt(softness);
}

void append_part(std::span<const double> values, double weight, std::vector<float>& signature) {
  for (const double value : values) {
    signature.push_back(static_cast<float>(weight * soft_root(value)));
  }
}

}  // namespace

std::vector<float> compute_fused_signature(std::span<const Ball> balls) {
  if (balls.empty()) return std::vector<float>(fused_size, 0.0F);
  const std::vector<Ball> solid = to_solid_frame(balls);
  std::vector<float> signature;
  signature.reserve(fused_size);
  append_part(solid_harmonics(solid), fused_parts[0].weight, signature);
  const auto surroundings = ball_surroundings(solid);
  for (std::size_t kind = 0; kind < surroundings.size(); ++kind) {
    append_part(surroundings[kind], fused_parts[1 + kind].weight, signature);
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
