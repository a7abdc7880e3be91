#pragma once

#include <cstddef>
#include <vector>

namespace mdbd {

/// The distances between the models of a collection: square, row after row.
class DistanceMatrix {
 public:
  explicit DistanceMatrix(std::size_t size) : size_(size), values_(size * size) {}

  std::size_t size() const { return size_; }
  double& operator()(std::size_t row, std::size_t column) { return values_[row * size_ + column]; }
  double operator()(std::size_t row, std::size_t column) const {
    return values_[row * size_ + column];
  }

 private:
  std::size_t size_;
  std::vector<double> values_;
};

}  // namespace mdbd
