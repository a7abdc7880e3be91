#include "bench/rival/candidate_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mdbd::bench {
namespace {

// The voxels from `middle` - `reach` to `middle` + `reach` that are in the grid.
std::pair<int, int> clamp_range(double middle, double reach, int count) {
  return {std::max(0, static_cast<int>(std::ceil(middle - reach))),
          std::min(count - 1, static_cast<int>(std::floor(middle + reach)))};
}

// The largest of values that are not negative; in lanes, for vector instructions.
float largest_of(std::span<const float> values) {
  constexpr std::size_t width = 8;
  std::array<float, width> lanes{};
  std::size_t i = 0;
  for (; i + width <= values.size(); i += width) {
    for (std::size_t j = 0; j < width; ++j) lanes[j] = std::max(lanes[j], values[i + j]);
  }
  for (; i < values.size(); ++i) lanes[0] = std::max(lanes[0], values[i]);
  return std::ranges::max(lanes);
}

}  // namespace

CandidateGrid::CandidateGrid(const VoxelGrid& grid, std::vector<float> values)
    : grid_(grid), values_(std::move(values)) {
  std::vector<std::pair<float, std::size_t>> rows;
  for (std::size_t i = 0; i < grid_.row_count(); ++i) {
    const float largest = largest_of(row(i));
    if (largest > 0) rows.emplace_back(largest, i);
  }
  rows_ = decltype(rows_)({}, std::move(rows));
}

std::span<float> CandidateGrid::row(std::size_t number) {
  const auto length = static_cast<std::size_t>(grid_.counts.x());
  return std::span(values_).subspan(number * length, length);
}

std::optional<CandidateGrid::Voxel> CandidateGrid::find_largest(float least) {
  while (!rows_.empty() && rows_.top().first > least) {
    const auto [bound, number] = rows_.top();
    const std::span<float> values = row(number);
    const float largest = largest_of(values);
    if (largest == bound) {
      return Voxel{static_cast<std::size_t>(&*std::ranges::find(values, bound) - values_.data()),
                   bound};
    }
    rows_.pop();
    if (largest > least) rows_.emplace(largest, number);
  }
  return std::nullopt;
}

void CandidateGrid::limit(const Voxel& voxel, float value) {
  values_[voxel.index] = std::min(values_[voxel.index], value);
}

void CandidateGrid::place(const Ball& ball, double largest) {
  const Eigen::Vector3d center = (ball.center - grid_.origin) / grid_.voxel_size;
  const double radius = ball.radius / grid_.voxel_size;
  const double reach = radius + largest / grid_.voxel_size;
  const auto [first_z, last_z] = clamp_range(center.z(), reach, grid_.counts.z());
  for (int z = first_z; z <= last_z; ++z) {
    const double left = std::sqrt(reach * reach - (z - center.z()) * (z - center.z()));
    const auto [first_y, last_y] = clamp_range(center.y(), left, grid_.counts.y());
    for (int y = first_y; y <= last_y; ++y) {
      place_in_row(static_cast<std::size_t>(z) * grid_.counts.y() + y, center, radius, reach);
    }
  }
}

// In units of voxels.
void CandidateGrid::place_in_row(std::size_t number, const Eigen::Vector3d& center, double radius,
                                 double reach) {
  const std::size_t slice = number / grid_.counts.y();
  const double y = static_cast<double>(number % grid_.counts.y()) - center.y();
  const double z = static_cast<double>(slice) - center.z();
  const double from_axis = y * y + z * z;
  const double half = std::sqrt(std::max(0.0, reach * reach - from_axis));
  const auto [first, last] = clamp_range(center.x(), half, grid_.counts.x());
  const auto size = static_cast<float>(grid_.voxel_size);
  const auto middle = static_cast<float>(center.x());
  const auto squared = static_cast<float>(from_axis);
  const auto inner = static_cast<float>(radius);
  const std::span<float> values = row(number);
  for (int x = first; x <= last; ++x) {
    const float offset = static_cast<float>(x) - middle;
    const float gap = size * (std::sqrt(squared + offset * offset) - inner);
    values[x] = std::min(values[x], std::max(gap, 0.0F));
  }
}

}  // namespace mdbd::bench
