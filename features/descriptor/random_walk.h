#pragma once

#include <span>
#include <vector>

#include "features/descriptor/contact_graph.h"

namespace mdbd {

/// The damped sums of a random walk on the contact graph (paper, sections 5.1 and 5.2).
struct WalkSums {
  std::vector<double> sums;  ///< sums[t - 1] = P_k^t = lambda^t * sum over i <= k of p^t(v_i)
  bool is_defined = true;    ///< false if all mass was lost (no edges); sums are then zeros
};

/// Walks `steps` steps from p^0(v_i) proportional to r_i with p^t = W p^{t-1}, w_ij = 1 / deg(v_j)
/// for touching balls, each p^t scaled to sum 1. A ball without contacts has a zero column.
/// The paper damps with lambda, the same at every step; here it is lambda^t, which is what "to
/// decrease the weights of long walks" asks for.
/// @pre graph and balls have the same size; counted_balls is k
WalkSums walk_sums(const ContactGraph& graph, std::span<const Ball> balls, int counted_balls,
                   int steps, double damping);

}  // namespace mdbd
