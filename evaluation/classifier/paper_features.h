#pragma once

#include <span>
#include <vector>

#include "features/core/ball.h"

namespace mdbd {

/// Which numbers of a decomposition are fed to the classifier (paper, section 5.3).
struct PaperFeatureOptions {
  int radii = 20;                   ///< n, how many radii
  int walk_balls = 10;              ///< k, how many balls' probabilities
  int walk_steps = 10;              ///< m, how many steps of the random walk
  double walk_damping = 0.9;        ///< lambda, damps the sum of step t by lambda^t
  double contact_tolerance = 1e-3;  ///< tau, relative to the smaller of two radii
};

/// The features that the paper classifies shapes with, 130 of them by default: the first n radii
/// divided by R, where the paper leaves them unscaled; the probabilities p^t(v_i) of the first k
/// balls at the steps t = 1 … m of the random walk on the contact graph of all balls, step after
/// step; and the m sums P_k^t. What a decomposition of few balls does not have is zero.
/// @param scale R, object units, above 0
std::vector<double> paper_features(std::span<const Ball> balls, double scale,
                                   const PaperFeatureOptions& options = {});

}  // namespace mdbd
