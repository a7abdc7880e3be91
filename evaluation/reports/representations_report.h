#pragma once

#include <cstddef>
#include <vector>

#include "evaluation/evaluation_input.h"
#include "report/report.h"

namespace mdbd {

struct RepresentationsOptions {
  /// Of the clouds without noise; not empty.
  std::vector<std::size_t> points = {5'000, 20'000, 100'000};
  std::size_t noisy_points = 20'000;  ///< of the clouds with noise
  double noise = 0.5;                 ///< percent of the enclosing ball's diameter
  std::size_t worst = 20;             ///< how many of the models that moved the furthest are listed
};

/// Tells whether a model is found by another representation of itself (paper, sections 4.3 and 5.2,
/// Figure 12): clouds of points drawn from the surface of each mesh, without normals, randomly
/// rotated, also with noise, query the collection of the meshes, and one in which every second mesh
/// is replaced by a cloud.
/// @throws Interrupted, StoreError, IoError; InvalidInput if no model could be described
Report make_representations_report(const EvaluationInput& input,
                                   const RepresentationsOptions& options);

}  // namespace mdbd
