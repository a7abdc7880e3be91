#include "picture/depth_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace mdbd {
namespace {

constexpr float behind_all = -std::numeric_limits<float>::infinity();

/// Light from the upper left in front, some from the front, and some from everywhere.
/// @param normal towards the viewer, of unit length
double light(const Eigen::Vector3d& normal) {
  static const Eigen::Vector3d lamp = Eigen::Vector3d(-0.45, 0.65, 0.6).normalized();
  return 0.16 + 0.62 * std::max(0.0, normal.dot(lamp)) + 0.22 * normal.z();
}

Eigen::Vector3d towards_viewer(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d unit = normal.normalized();
  return unit.z() < 0 ? Eigen::Vector3d(-unit) : unit;
}

}  // namespace

DepthImage::DepthImage(int size)
    : size_(size),
      depth_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), behind_all),
      brightness_(depth_.size(), nothing) {}

void DepthImage::draw_triangle(const std::array<Eigen::Vector3d, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  if (normal.z() == 0) return;  // seen from the side
  const double brightness = light(towards_viewer(normal));
  const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
  const auto [bottom, top] = std::minmax({a.y(), b.y(), c.y()});
  const Window seen = window(left, right, bottom, top);
  // The share of a corner is the part of the area that lies opposite to it.
  const auto share = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, double x, double y) {
    return ((q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x())) / normal.z();
  };
  for (int row = seen.bottom; row <= seen.top; ++row) {
    for (int column = seen.left; column <= seen.right; ++column) {
      const double x = column + 0.5;
      const double y = row + 0.5;
      const double of_a = share(b, c, x, y);
      const double of_b = share(c, a, x, y);
      const double of_c = share(a, b, x, y);
      if (of_a < 0 || of_b < 0 || of_c < 0) continue;
      put(column, row, of_a * a.z() + of_b * b.z() + of_c * c.z(), brightness);
    }
  }
}

void DepthImage::draw_disc(const Eigen::Vector3d& center, const Eigen::Vector3d& normal,
                           double radius) {
  const Eigen::Vector3d unit = towards_viewer(normal);
  const double brightness = light(unit);
  const Window seen =
      window(center.x() - radius, center.x() + radius, center.y() - radius, center.y() + radius);
  const double slope = std::max(unit.z(), 0.1);  // a disc seen from the side has no end of depth
  for (int row = seen.bottom; row <= seen.top; ++row) {
    for (int column = seen.left; column <= seen.right; ++column) {
      const double x = column + 0.5 - center.x();
      const double y = row + 0.5 - center.y();
      const double z = -(x * unit.x() + y * unit.y()) / slope;
      if (x * x + y * y + z * z > radius * radius) continue;
      put(column, row, center.z() + z, brightness);
    }
  }
}

void DepthImage::draw_ball(const Eigen::Vector3d& center, double radius) {
  const Window seen =
      window(center.x() - radius, center.x() + radius, center.y() - radius, center.y() + radius);
  for (int row = seen.bottom; row <= seen.top; ++row) {
    for (int column = seen.left; column <= seen.right; ++column) {
      const double x = (column + 0.5 - center.x()) / radius;
      const double y = (row + 0.5 - center.y()) / radius;
      const double rest = 1.0 - x * x - y * y;
      if (rest < 0) continue;
      const Eigen::Vector3d normal(x, y, std::sqrt(rest));
      put(column, row, center.z() + radius * normal.z(), light(normal));
    }
  }
}

void DepthImage::draw_outlines(double step) {
  constexpr float darkening = 0.45F;
  std::vector<float> outlined = brightness_;
  for (int row = 0; row < size_; ++row) {
    for (int column = 0; column < size_; ++column) {
      if (is_step(column, row, step)) outlined[index(column, row)] *= darkening;
    }
  }
  brightness_ = std::move(outlined);
}

bool DepthImage::is_step(int column, int row, double step) const {
  const float depth = depth_[index(column, row)];
  if (depth == behind_all) return false;
  const auto is_behind = [&](int x, int y) {
    const bool is_inside = x >= 0 && y >= 0 && x < size_ && y < size_;
    return is_inside && depth - depth_[index(x, y)] > step;
  };
  return is_behind(column - 1, row) || is_behind(column + 1, row) || is_behind(column, row - 1) ||
         is_behind(column, row + 1);
}

DepthImage::Window DepthImage::window(double left, double right, double bottom, double top) const {
  const auto sample = [&](double value) {
    return static_cast<int>(std::floor(std::clamp(value, -1.0, size_ + 0.0)));
  };
  return {std::max(sample(left), 0), std::min(sample(right), size_ - 1),
          std::max(sample(bottom), 0), std::min(sample(top), size_ - 1)};
}

void DepthImage::put(int x, int y, double depth, double brightness) {
  const std::size_t at = index(x, size_ - 1 - y);
  const auto z = static_cast<float>(depth);
  if (z <= depth_[at]) return;
  depth_[at] = z;
  brightness_[at] = static_cast<float>(brightness);
}

}  // namespace mdbd
