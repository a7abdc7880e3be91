#include "features/descriptor/contact_graph.h"

#include <algorithm>

namespace mdbd {

ContactGraph build_contact_graph(std::span<const Ball> balls, double contact_tolerance) {
  ContactGraph graph{std::vector<std::vector<std::uint32_t>>(balls.size())};
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      const double gap =
          (balls[i].center - balls[j].center).norm() - balls[i].radius - balls[j].radius;
      if (gap > contact_tolerance * std::min(balls[i].radius, balls[j].radius)) continue;
      graph.neighbours[i].push_back(j);
      graph.neighbours[j].push_back(i);
    }
  }
  return graph;
}

}  // namespace mdbd
