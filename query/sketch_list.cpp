#include "query/sketch_list.h"

#include <algorithm>
#include <array>

#include "query/metric_block.h"

namespace mdbd {
namespace {

constexpr std::size_t lanes = 8;
constexpr std::size_t batch_size = 256;

}  // namespace

SketchList::SketchList(std::span<const float> points, std::size_t dimension)
    : rows_(points.size() / dimension),
      stride_((dimension + lanes - 1) / lanes * lanes),
      points_(rows_ * stride_, 0.0F) {
  for (std::size_t row = 0; row < rows_; ++row) {
    std::ranges::copy(points.subspan(row * dimension, dimension),
                      points_.begin() + static_cast<std::ptrdiff_t>(row * stride_));
  }
}

void SketchList::visit_within(std::span<const float> query, double radius,
                              const Visitor& visitor) const {
  std::vector<float> point(query.begin(), query.end());
  point.resize(stride_, 0.0F);
  std::array<float, batch_size> distances{};
  const double least_share = 1.0 - single_precision_margin(stride_);
  for (std::size_t first = 0; first < rows_; first += batch_size) {
    const std::size_t count = std::min(batch_size, rows_ - first);
    l1_distances(point, std::span(points_).subspan(first * stride_, count * stride_),
                 std::span(distances).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      if (distances[i] * least_share <= radius) radius = visitor(first + i);
    }
  }
}

}  // namespace mdbd
