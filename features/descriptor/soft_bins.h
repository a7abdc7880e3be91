#pragma once

#include <algorithm>
#include <cstddef>

namespace mdbd {

/// Where a number lies between two neighbouring nodes.
struct SoftBin {
  std::size_t lower = 0;  ///< the node below; the other one is lower + 1
  double share = 0.0;     ///< of the node above, from 0 to 1; 1 - share is that of the lower one
};

/// Evenly spaced nodes between which a number is shared, so that sums over numbers change
/// continuously with them: the hat functions of linear interpolation. Numbers beyond the ends count
/// at the ends.
struct SoftBins {
  double first = 0.0;  ///< the first node
  double last = 1.0;   ///< the last node, above the first
  std::size_t count = 2;

  constexpr double node(std::size_t i) const {
    return first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1);
  }

  SoftBin find(double x) const {
    const auto cells = static_cast<double>(count - 1);
    const double position = std::clamp((x - first) / (last - first) * cells, 0.0, cells);
    const std::size_t lower = std::min(static_cast<std::size_t>(position), count - 2);
    return {lower, position - static_cast<double>(lower)};
  }
};

}  // namespace mdbd
