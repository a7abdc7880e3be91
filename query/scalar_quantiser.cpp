#include "query/scalar_quantiser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdbd {
namespace {

constexpr double steps = 255.0;

// How many standard deviations of the number that varies the most the lattice spans: more of them
// make the steps coarser, fewer bring points that are far apart together. Measured on real and
// made-up vectors (docs/search.md).
constexpr double span = 4.0;

std::vector<double> mean_of(std::span<const float> points, std::size_t dimension) {
  std::vector<double> sums(dimension, 0.0);
  for (std::size_t first = 0; first < points.size(); first += dimension) {
    for (std::size_t i = 0; i < dimension; ++i) sums[i] += points[first + i];
  }
  const auto rows = static_cast<double>(points.size() / dimension);
  for (double& sum : sums) sum /= rows;
  return sums;
}

double largest_deviation(std::span<const float> points, std::span<const double> mean) {
  std::vector<double> squares(mean.size(), 0.0);
  for (std::size_t first = 0; first < points.size(); first += mean.size()) {
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const double difference = points[first + i] - mean[i];
      squares[i] += difference * difference;
    }
  }
  const auto rows = static_cast<double>(points.size() / mean.size());
  return std::sqrt(*std::ranges::max_element(squares) / rows);
}

}  // namespace

ScalarQuantiser::ScalarQuantiser(std::span<const float> points, std::size_t dimension)
    : corner_(mean_of(points, dimension)) {
  step_ = std::max<double>(span * largest_deviation(points, corner_) / steps,
                           std::numeric_limits<float>::min());
  for (double& coordinate : corner_) coordinate -= 0.5 * steps * step_;
}

void ScalarQuantiser::locate(std::span<const float> point, std::span<float> place) const {
  for (std::size_t i = 0; i < point.size(); ++i) {
    place[i] = static_cast<float>(std::clamp((point[i] - corner_[i]) / step_, 0.0, steps));
  }
}

// Both places round by half an epsilon of 255 at most, and the double precision before that by next
// to nothing.
double ScalarQuantiser::rounding() const {
  constexpr double epsilon = std::numeric_limits<float>::epsilon();
  return 2.0 * epsilon * steps * static_cast<double>(corner_.size());
}

double ScalarQuantiser::write(std::span<const float> place, PointNorm norm,
                              std::span<std::uint8_t> bytes) {
  double sum = 0.0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    bytes[i] = static_cast<std::uint8_t>(place[i] + 0.5F);
    const double error = std::abs(double{place[i]} - bytes[i]);
    sum += norm == PointNorm::l1 ? error : error * error;
  }
  return norm == PointNorm::l1 ? sum : std::sqrt(sum);
}

}  // namespace mdbd
