#include "features/descriptor/compute_descriptor.h"

#include "features/descriptor/contact_graph.h"
#include "features/descriptor/random_walk.h"

namespace mdbd {

Descriptor compute_descriptor(const BallDecomposition& decomposition, const Recipe& recipe) {
  const std::vector<Ball>& balls = decomposition.balls;
  const ContactGraph graph = build_contact_graph(balls, recipe.contact_tolerance);
  const RandomWalk walk = random_walk(graph, balls, recipe.walk_steps);
  Descriptor descriptor;
  descriptor.radius_count = recipe.descriptor_balls;
  descriptor.walk_is_defined = walk.is_defined;
  for (int i = 0; i < recipe.descriptor_balls; ++i) {
    const bool exists = i < static_cast<int>(balls.size());
    const double radius = exists ? balls[i].radius / decomposition.scale : 0.0;
    descriptor.values.push_back(static_cast<float>(radius));
  }
  for (const double sum : walk_sums(walk, recipe.descriptor_balls, recipe.walk_damping)) {
    descriptor.values.push_back(static_cast<float>(sum));
  }
  return descriptor;
}

}  // namespace mdbd
