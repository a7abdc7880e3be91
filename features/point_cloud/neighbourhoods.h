#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace mdbd {

/// The nearest other points of each point of a cloud.
class Neighbourhoods {
 public:
  /// Finds them by PCL's kd-tree over FLANN: exact but for single precision, in which the cloud is
  /// held relative to the middle of its box.
  /// @param size how many for each point; fewer if there are not so many others
  /// @pre at least two points, all different from each other
  Neighbourhoods(std::span<const Eigen::Vector3d> points, std::size_t size);

  std::size_t size() const { return size_; }  ///< of each neighbourhood

  /// The neighbours of a point, nearest first.
  std::span<const std::uint32_t> of(std::size_t point) const {
    return std::span(neighbours_).subspan(point * size_, size_);
  }

 private:
  std::size_t size_;
  std::vector<std::uint32_t> neighbours_;
};

}  // namespace mdbd
