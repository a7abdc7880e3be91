#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// A square image in which what is nearer hides what is behind it (z-buffer), each sample lit by
/// its normal. Points are in samples: x to the right and y up from the lower left corner, z towards
/// the viewer. What lies outside is cut off.
class DepthImage {
 public:
  /// A sample that nothing was drawn at.
  static constexpr float nothing = -1.0F;

  /// @param size samples along a side, at least 1
  explicit DepthImage(int size);

  int size() const { return size_; }

  /// Both sides are lit alike.
  void draw_triangle(const std::array<Eigen::Vector3d, 3>& corners);
  /// A disc in space, for a sample of a surface.
  /// @param normal any length but 0
  void draw_disc(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double radius);
  void draw_ball(const Eigen::Vector3d& center, double radius);

  /// Darkens what stands in front of something that is further behind than a number of samples.
  void draw_outlines(double step);

  /// Brightness at a sample, 0 to 1, or `nothing`. Row 0 is at the top.
  float brightness(int column, int row) const { return brightness_[index(column, row)]; }

 private:
  struct Window {
    int left, right, bottom, top;  ///< the last ones are in it
  };
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) +
           static_cast<std::size_t>(column);
  }
  Window window(double left, double right, double bottom, double top) const;
  void put(int x, int y, double depth, double brightness);
  bool is_step(int column, int row, double step) const;

  int size_;
  std::vector<float> depth_;
  std::vector<float> brightness_;
};

}  // namespace mdbd
