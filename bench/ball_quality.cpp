#include "bench/ball_quality.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "features/core/recipe.h"
#include "features/descriptor/contact_graph.h"

namespace mdbd::bench {
namespace {

std::size_t count_contacts(std::span<const Ball> balls) {
  const ContactGraph graph = build_contact_graph(balls, Recipe{}.contact_tolerance);
  std::size_t ends = 0;
  for (const auto& neighbours : graph.neighbours) ends += neighbours.size();
  return ends / 2;
}

double largest_escape(const DistanceField& field, std::span<const Ball> balls) {
  double escape = 0.0;
  for (const Ball& ball : balls) {
    const double distance = field.measure(DistanceQuery{ball.center}).distance;
    escape = std::max(escape, ball.radius - distance);
  }
  return escape;
}

double largest_overlap(std::span<const Ball> balls) {
  double overlap = 0.0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = (balls[i].center - balls[j].center).norm();
      overlap = std::max(overlap, balls[i].radius + balls[j].radius - distance);
    }
  }
  return overlap;
}

double largest_order_violation(std::span<const Ball> balls) {
  double smallest = std::numeric_limits<double>::infinity();
  double violation = 0.0;
  for (const Ball& ball : balls) {
    violation = std::max(violation, ball.radius / smallest - 1.0);
    smallest = std::min(smallest, ball.radius);
  }
  return violation;
}

std::vector<double> sorted_radii(std::span<const Ball> balls) {
  std::vector<double> radii;
  for (const Ball& ball : balls) radii.push_back(ball.radius);
  std::ranges::sort(radii, std::greater());
  return radii;
}

double mean_radius_error(std::span<const Ball> balls, std::span<const Ball> reference) {
  const std::vector<double> radii = sorted_radii(balls);
  const std::vector<double> exact = sorted_radii(reference);
  const std::size_t common = std::min(radii.size(), exact.size());
  const std::size_t all = std::max(radii.size(), exact.size());
  if (all == 0) return 0.0;
  auto sum = static_cast<double>(all - common);
  for (std::size_t i = 0; i < common; ++i) sum += std::abs(radii[i] / exact[i] - 1.0);
  return sum / static_cast<double>(all);
}

}  // namespace

BallQuality measure_quality(const DistanceField& field, std::span<const Ball> balls,
                            std::span<const Ball> reference) {
  const double scale = field.enclosing_ball().radius;
  return {.balls = balls.size(),
          .contacts = count_contacts(balls),
          .escape = largest_escape(field, balls) / scale,
          .overlap = largest_overlap(balls) / scale,
          .order_violation = largest_order_violation(balls),
          .radius_error = mean_radius_error(balls, reference)};
}

}  // namespace mdbd::bench
