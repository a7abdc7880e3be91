#include "evaluation/classifier/paper_features.h"

#include "features/descriptor/contact_graph.h"
#include "features/descriptor/random_walk.h"

namespace mdbd {

std::vector<double> paper_features(std::span<const Ball> balls, double scale,
                                   const PaperFeatureOptions& options) {
  const ContactGraph graph = build_contact_graph(balls, options.contact_tolerance);
  const RandomWalk walk = random_walk(graph, balls, options.walk_steps);
  std::vector<double> features;
  for (std::size_t i = 0; i < static_cast<std::size_t>(options.radii); ++i) {
    features.push_back(i < balls.size() ? balls[i].radius / scale : 0.0);
  }
  for (const std::vector<double>& distribution : walk.distributions) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(options.walk_balls); ++i) {
      features.push_back(i < distribution.size() ? distribution[i] : 0.0);
    }
  }
  const std::vector<double> sums = walk_sums(walk, options.walk_balls, options.walk_damping);
  features.insert(features.end(), sums.begin(), sums.end());
  return features;
}

}  // namespace mdbd
