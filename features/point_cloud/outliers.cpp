#include "features/point_cloud/outliers.h"

#include <algorithm>

namespace mdbd {
namespace {

constexpr double most_times_neighbours = 4.0;
constexpr double most_times_usual = 10.0;
constexpr double largest_share = 0.05;

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// How far the farthest of each point's neighbours is away.
std::vector<double> neighbourhood_radii(const PointCloud& cloud,
                                        const Neighbourhoods& neighbourhoods) {
  std::vector<double> radii;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    radii.push_back((cloud.points[neighbourhoods.of(i).back()] - cloud.points[i]).norm());
  }
  return radii;
}

}  // namespace

std::vector<bool> find_outliers(const PointCloud& cloud, const Neighbourhoods& neighbourhoods) {
  const std::vector<double> radii = neighbourhood_radii(cloud, neighbourhoods);
  std::vector<double> sample = radii;
  const double usual = median(sample);
  std::vector<bool> is_outlier(radii.size());
  for (std::size_t i = 0; i < radii.size(); ++i) {
    sample.clear();
    for (const std::uint32_t neighbour : neighbourhoods.of(i)) sample.push_back(radii[neighbour]);
    is_outlier[i] =
        radii[i] > most_times_neighbours * median(sample) || radii[i] > most_times_usual * usual;
  }
  const auto count = static_cast<double>(std::ranges::count(is_outlier, true));
  if (count > largest_share * static_cast<double>(radii.size())) {
    return std::vector<bool>(radii.size());
  }
  return is_outlier;
}

}  // namespace mdbd
