#pragma once

#include <span>
#include <vector>

#include "features/descriptor/contact_graph.h"

namespace mdbd {

/// A random walk on the contact graph (paper, section 5.1).
struct RandomWalk {
  std::vector<std::vector<double>> distributions;  ///< distributions[t - 1][i - 1] = p^t(v_i)
  bool is_defined = true;  ///< false if all mass was lost (no edges); all p^t are then zeros
};

/// Walks `steps` steps from p^0(v_i) proportional to r_i with p^t = W p^{t-1}, w_ij = 1 / deg(v_j)
/// for touching balls, each p^t scaled to sum 1. A ball without contacts has a zero column.
/// @pre graph and balls have the same size
RandomWalk random_walk(const ContactGraph& graph, std::span<const Ball> balls, int steps);

/// The damped sums over the first balls (paper, section 5.2): of step t, P_k^t at [t - 1], which is
/// lambda^t times the sum over i <= k of p^t(v_i). The paper damps with lambda, the same at every
/// step; here it is lambda^t, which is what "to decrease the weights of long walks" asks for.
/// @param counted_balls k
std::vector<double> walk_sums(const RandomWalk& walk, int counted_balls, double damping);

}  // namespace mdbd
