#include "features/descriptor/similarity_distance.h"

#include <cmath>

namespace mdbd {
namespace {

double euclidean_distance(std::span<const float> f, std::span<const float> g) {
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double difference = static_cast<double>(f[i]) - static_cast<double>(g[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

}  // namespace

SimilarityDistance similarity_distance(std::span<const float> f, std::span<const float> g,
                                       int radius_count, double walk_weight) {
  SimilarityDistance distance;
  distance.radii = euclidean_distance(f.first(radius_count), g.first(radius_count));
  distance.walk = euclidean_distance(f.subspan(radius_count), g.subspan(radius_count));
  distance.total = distance.radii + walk_weight * distance.walk;
  return distance;
}

}  // namespace mdbd
