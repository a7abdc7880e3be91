#include "query/sketch_list.h"

#include <algorithm>
#include <array>
#include <compare>
#include <limits>
#include <queue>
#include <utility>

namespace mdbd {
namespace {

constexpr std::size_t batch_groups = 8;
// Rows are not announced before they are visited at once, so that there must not be too many.
constexpr std::size_t least_at_once = 16;
constexpr std::size_t most_at_once = 1024;
constexpr std::size_t announced_together = 512;

/// A distance in the terms of find_within(), whole: L2 is squared.
std::uint32_t to_limit(double steps, PointNorm norm) {
  steps = std::max(steps, 0.0);
  const double limit = norm == PointNorm::l2 ? steps * steps : steps;
  constexpr auto largest = std::numeric_limits<std::uint32_t>::max();
  return limit < largest ? static_cast<std::uint32_t>(limit) : largest;
}

/// The smallest distances so far.
class SmallestSoFar {
 public:
  explicit SmallestSoFar(std::size_t count) : count_(count) {}

  /// Whether a distance is among the smallest.
  bool takes(std::uint32_t distance) {
    if (distances_.size() == count_) {
      if (distance >= distances_.top()) return false;
      distances_.pop();
    }
    distances_.push(distance);
    return true;
  }

 private:
  std::size_t count_;
  std::priority_queue<std::uint32_t> distances_;
};

/// A row that may be within the radius.
struct Candidate {
  std::uint32_t distance;
  std::size_t row;

  auto operator<=>(const Candidate&) const = default;
};

/// Finds the points of groups within a limit, in order.
/// @param take is given the distance and the number of each, and may lower the limit
template <typename Take>
void for_each_within(std::span<const std::uint8_t> point, std::span<const std::uint8_t> groups,
                     PointNorm norm, const std::uint32_t& limit, const Take& take) {
  std::array<GroupedPoint, batch_groups * SketchList::group_size> batch;
  const std::size_t count = groups.size() / point.size();
  for (std::size_t first = 0; first < count; first += batch.size()) {
    const std::span<GroupedPoint> found =
        std::span(batch).first(std::min(batch.size(), count - first));
    const std::size_t found_count =
        find_within(point, groups.subspan(first * point.size(), found.size() * point.size()), norm,
                    limit, found);
    for (const GroupedPoint& near : found.first(found_count)) {
      if (near.distance <= limit) take(near.distance, first + near.number);
    }
  }
}

}  // namespace

SketchList::SketchList(std::span<const float> points, std::size_t dimension, PointNorm norm)
    : quantiser_(points, dimension), rows_(points.size() / dimension), norm_(norm) {
  auto groups = std::make_shared<std::vector<std::uint8_t>>(grouped_size(rows_, dimension));
  std::vector<float> place(dimension);
  std::vector<std::uint8_t> bytes(dimension);
  for (std::size_t row = 0; row < rows_; ++row) {
    quantiser_.locate(points.subspan(row * dimension, dimension), place);
    largest_error_ = std::max(largest_error_, ScalarQuantiser::write(place, norm, bytes));
    auto* target = groups->data() + row / group_size * group_size * dimension + row % group_size;
    for (std::size_t i = 0; i < dimension; ++i) target[i * group_size] = bytes[i];
  }
  groups_ = *groups;
  owner_ = std::move(groups);
}

SketchList::SketchList(ScalarQuantiser quantiser, double largest_error,
                       std::span<const std::uint8_t> groups, std::size_t rows, PointNorm norm,
                       std::shared_ptr<const void> owner)
    : quantiser_(std::move(quantiser)),
      largest_error_(largest_error),
      rows_(rows),
      norm_(norm),
      groups_(groups),
      owner_(std::move(owner)) {}

std::vector<float> SketchList::points() const {
  std::vector<float> points(rows_ * dimension());
  for (std::size_t row = 0; row < rows_; ++row) {
    const std::size_t first = row / group_size * group_size * dimension() + row % group_size;
    for (std::size_t i = 0; i < dimension(); ++i) {
      points[row * dimension() + i] = groups_[first + i * group_size];
    }
  }
  return points;
}

double SketchList::reach(double radius) const {
  return radius / quantiser_.step() + largest_error_ + quantiser_.rounding();
}

void SketchList::visit_within(std::span<const float> query, double radius, std::size_t count,
                              const Visitor& visitor, const Announcement& announce) const {
  std::vector<float> place(dimension());
  std::vector<std::uint8_t> bytes(dimension());
  quantiser_.locate(query, place);
  const double error = ScalarQuantiser::write(place, norm_, bytes);
  const auto limit_of = [&](double within) { return to_limit(reach(within) + error, norm_); };
  std::uint32_t limit = limit_of(radius);
  SmallestSoFar smallest(std::clamp(count, least_at_once, most_at_once));
  std::vector<Candidate> others;
  for_each_within(bytes, groups_, norm_, limit, [&](std::uint32_t distance, std::size_t row) {
    if (row >= rows_) return;  // what fills up the last group
    if (smallest.takes(distance)) {
      limit = limit_of(visitor(row));
    } else {
      others.push_back({distance, row});
    }
  });
  std::erase_if(others, [&](const Candidate& other) { return other.distance > limit; });
  std::ranges::sort(others);
  for (std::size_t i = 0; i < others.size() && others[i].distance <= limit; ++i) {
    if (announce && i % announced_together == 0) {
      for (const Candidate& other :
           std::span(others).subspan(i, std::min(announced_together, others.size() - i))) {
        announce(other.row);
      }
    }
    limit = limit_of(visitor(others[i].row));
  }
}

}  // namespace mdbd
