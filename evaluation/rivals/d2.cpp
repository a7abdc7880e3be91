#include "evaluation/rivals/d2.h"

#include <algorithm>
#include <numeric>

#include "evaluation/rivals/surface_samples.h"

namespace mdbd {

std::vector<float> compute_d2(const TriangleMesh& mesh, std::uint64_t seed) {
  const std::vector<Eigen::Vector3f> points = sample_surface(mesh, 2 * d2_pairs, seed);
  std::vector<double> distances;
  distances.reserve(d2_pairs);
  for (std::size_t i = 0; i < d2_pairs; ++i) {
    distances.push_back((points[2 * i] - points[2 * i + 1]).cast<double>().norm());
  }
  const double sum = std::accumulate(distances.begin(), distances.end(), 0.0);
  const double bins_per_length = d2_bins / (d2_range * sum / d2_pairs);
  std::vector<std::size_t> counts(d2_bins);
  for (const double distance : distances) {
    ++counts[std::min(static_cast<std::size_t>(distance * bins_per_length), d2_bins - 1)];
  }
  std::vector<float> histogram;
  for (const std::size_t count : counts) {
    histogram.push_back(static_cast<float>(count) / static_cast<float>(d2_pairs));
  }
  return histogram;
}

}  // namespace mdbd
