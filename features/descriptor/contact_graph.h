#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "features/core/ball.h"

namespace mdbd {

/// The contact graph of a decomposition (paper, section 2.3): vertices are balls, edges join
/// tangent pairs. neighbours[i] lists the balls that touch ball i, in increasing order.
struct ContactGraph {
  std::vector<std::vector<std::uint32_t>> neighbours;
};

/// Joins balls i and j if |c_i - c_j| - r_i - r_j <= contact_tolerance * min(r_i, r_j).
ContactGraph build_contact_graph(std::span<const Ball> balls, double contact_tolerance);

}  // namespace mdbd
