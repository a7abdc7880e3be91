#include "features/implicit/csg_solid.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace mdbd {
namespace {

using Kind = CsgSolid::Step::Kind;

constexpr std::size_t most_at_a_point = 8;  // surfaces of which all sides are tried

}  // namespace

Eigen::AlignedBox3d unbounded_box() {
  const double infinity = std::numeric_limits<double>::infinity();
  return {Eigen::Vector3d::Constant(-infinity), Eigen::Vector3d::Constant(infinity)};
}

void CsgSolid::measure_surfaces(const Eigen::Vector3d& x, std::vector<double>& distances) const {
  distances.resize(surfaces_.size());
  for (std::size_t i = 0; i < surfaces_.size(); ++i) distances[i] = surfaces_[i].distance(x);
}

double CsgSolid::value(const std::vector<double>& distances) const {
  constexpr std::size_t usual_depth = 64;
  double usual[usual_depth] = {};
  std::vector<double> deep(depth_ > usual_depth ? depth_ : 0);
  double* const stack = deep.empty() ? usual : deep.data();
  std::size_t top = 0;
  for (const Step& step : steps_) {
    if (step.kind == Kind::surface) {
      stack[top++] = step.sign * distances[step.count];
      continue;
    }
    double* const first = stack + top - step.count;
    *first = step.kind == Kind::maximum ? *std::max_element(first, stack + top)
                                        : *std::min_element(first, stack + top);
    top -= step.count - 1;
  }
  return stack[0];
}

std::vector<std::uint32_t> CsgSolid::deciding_surfaces(const std::vector<double>& distances,
                                                       double reach) const {
  // All values change by `reach` at most, so those that are less by twice as much never decide.
  std::vector<double> values(steps_.size());
  std::vector<bool> decides(steps_.size(), false);
  const auto for_each_operand = [&](std::size_t i, const auto& use) {
    for (std::size_t next = i, left = steps_[i].count; left > 0; --left) {
      use(next - 1);
      next = steps_[next - 1].begin;
    }
  };
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    if (step.kind == Kind::surface) {
      values[i] = step.sign * distances[step.count];
      continue;
    }
    const bool is_maximum = step.kind == Kind::maximum;
    values[i] = values[i - 1];
    for_each_operand(i, [&](std::size_t operand) {
      values[i] =
          is_maximum ? std::max(values[i], values[operand]) : std::min(values[i], values[operand]);
    });
  }
  std::vector<std::uint32_t> surfaces;
  decides.back() = true;
  for (std::size_t i = steps_.size(); i-- > 0;) {
    if (!decides[i]) continue;
    if (steps_[i].kind == Kind::surface) {
      if (std::abs(values[i]) <= reach) surfaces.push_back(steps_[i].count);
      continue;
    }
    for_each_operand(i, [&](std::size_t operand) {
      decides[operand] = std::abs(values[operand] - values[i]) <= 2.0 * reach;
    });
  }
  std::ranges::sort(surfaces);
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  return surfaces;
}

CsgSolid::Signs CsgSolid::signs_around(std::vector<double>& distances, double tolerance) const {
  std::array<std::size_t, most_at_a_point> near;
  std::size_t count = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (std::abs(distances[i]) > tolerance) continue;
    if (count == most_at_a_point) return {true, true};
    near[count++] = i;
  }
  Signs signs;
  for (std::size_t sides = 0; sides < std::size_t{1} << count; ++sides) {
    for (std::size_t i = 0; i < count; ++i) {
      distances[near[i]] = (sides >> i & 1) != 0 ? tolerance : -tolerance;
    }
    (value(distances) > 0 ? signs.has_inside : signs.has_outside) = true;
  }
  return signs;
}

bool CsgSolid::is_boundary(const Eigen::Vector3d& x, double tolerance) const {
  thread_local std::vector<double> distances;
  measure_surfaces(x, distances);
  const Signs signs = signs_around(distances, tolerance);
  return signs.has_inside && signs.has_outside;
}

bool CsgSolid::contains(std::vector<double>& distances, double tolerance) const {
  const double f = value(distances);
  if (std::abs(f) > tolerance) return f > 0;
  return !signs_around(distances, tolerance).has_outside;
}

void CsgBuilder::add(const Surface& surface, bool is_inside, const Eigen::AlignedBox3d& bounds) {
  std::vector<Surface>& surfaces = solid_.surfaces_;
  int same = 0;
  std::uint32_t number = 0;
  for (; number < surfaces.size(); ++number) {
    same = surfaces[number].compare(surface);
    if (same != 0) break;
  }
  if (same == 0) surfaces.push_back(surface);
  const double sign = (is_inside ? 1.0 : -1.0) * (same == 0 ? 1 : same);
  const auto begin = static_cast<std::uint32_t>(solid_.steps_.size());
  begins_.push_back(begin);
  solid_.steps_.push_back({.kind = Kind::surface, .count = number, .sign = sign, .begin = begin});
  bounds_.push_back(bounds);
  solid_.depth_ = std::max(solid_.depth_, bounds_.size());
}

void CsgBuilder::unite(std::size_t count) { combine(Kind::maximum, count); }

void CsgBuilder::intersect(std::size_t count) { combine(Kind::minimum, count); }

void CsgBuilder::combine(Kind kind, std::size_t count) {
  begins_.resize(begins_.size() - (count - 1));
  solid_.steps_.push_back({.kind = kind,
                           .count = static_cast<std::uint32_t>(count),
                           .sign = 1.0,
                           .begin = begins_.back()});
  for (; count > 1; --count) {
    const Eigen::AlignedBox3d last = bounds_.back();
    bounds_.pop_back();
    Eigen::AlignedBox3d& box = bounds_.back();
    if (kind == Kind::maximum) {
      box.extend(last);
    } else {
      box = box.intersection(last);
    }
  }
}

CsgSolid CsgBuilder::finish() && {
  solid_.bounds_ = bounds_.back();
  return std::move(solid_);
}

}  // namespace mdbd
