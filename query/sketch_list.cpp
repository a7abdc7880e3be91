#include "query/sketch_list.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace mdbd {
namespace {

constexpr std::size_t batch_groups = 32;

}  // namespace

SketchList::SketchList(std::span<const float> points, std::size_t dimension, PointNorm norm)
    : rows_(points.size() / dimension), dimension_(dimension), norm_(norm) {
  auto groups = std::make_shared<std::vector<float>>(grouped_size(rows_, dimension), 0.0F);
  for (std::size_t row = 0; row < rows_; ++row) {
    float* target = groups->data() + row / group_size * group_size * dimension + row % group_size;
    for (std::size_t i = 0; i < dimension; ++i) {
      target[i * group_size] = points[row * dimension + i];
    }
  }
  groups_ = *groups;
  owner_ = std::move(groups);
}

SketchList::SketchList(std::span<const float> groups, std::size_t rows, std::size_t dimension,
                       PointNorm norm, std::shared_ptr<const void> owner)
    : rows_(rows), dimension_(dimension), norm_(norm), groups_(groups), owner_(std::move(owner)) {}

std::vector<float> SketchList::points() const {
  std::vector<float> points(rows_ * dimension_);
  for (std::size_t row = 0; row < rows_; ++row) {
    const std::size_t first = row / group_size * group_size * dimension_ + row % group_size;
    for (std::size_t i = 0; i < dimension_; ++i) {
      points[row * dimension_ + i] = groups_[first + i * group_size];
    }
  }
  return points;
}

// The radius in terms of what is computed, of which rounding takes nothing off: L2 is squared.
float SketchList::limit_of(double radius) const {
  double limit = radius / (1.0 - 2.0 * single_precision_margin(8 * dimension_));
  if (norm_ == PointNorm::l2) limit = limit * limit + std::numeric_limits<float>::min();
  return limit < std::numeric_limits<float>::max() ? static_cast<float>(limit)
                                                   : std::numeric_limits<float>::infinity();
}

void SketchList::visit_within(std::span<const float> query, double radius,
                              const Visitor& visitor) const {
  std::array<float, batch_groups * group_size> distances{};
  float limit = limit_of(radius);
  for (std::size_t first = 0; first < rows_; first += distances.size()) {
    const std::size_t count = std::min(distances.size(), rows_ - first);
    const std::size_t group_count = (count + group_size - 1) / group_size;
    grouped_distances(query,
                      groups_.subspan(first * dimension_, group_count * group_size * dimension_),
                      norm_, std::span(distances).first(group_count * group_size));
    for (std::size_t i = 0; i < count; ++i) {
      if (distances[i] <= limit) limit = limit_of(visitor(first + i));
    }
  }
}

}  // namespace mdbd
