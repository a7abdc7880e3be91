#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace mdbd {

/// A partition of the numbers from 0 to n - 1 into sets that are joined one by one (Tarjan,
/// Efficiency of a good but not linear set union algorithm, 1975; with path halving).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  /// The number that stands for the set of another.
  std::uint32_t root(std::uint32_t number) {
    while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
    return number;
  }

  /// Joins the set of `other` to the set of `number`, whose root stands for both.
  void join(std::uint32_t number, std::uint32_t other) { parent_[root(other)] = root(number); }

 private:
  std::vector<std::uint32_t> parent_;  // of each number, up to a root, which is its own
};

}  // namespace mdbd
