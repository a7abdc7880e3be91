#include "features/descriptor/pair_distances.h"

#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "tests/support/ball_clouds.h"
#include "tests/support/sphere_points.h"

using namespace mdbd;
using namespace mdbd::test;

TEST_CASE("two balls make three pairs, of which two are each with itself") {
  // Distances: sqrt(1.2) * 0.1 within a ball, between them sqrt(4 + 0.012).
  const std::vector<double> found =
      pair_distances(std::vector<Ball>{{{-1, 0, 0}, 0.1}, {{1, 0, 0}, 0.1}});
  REQUIRE(found.size() == pair_distance_nodes);
  const double within = std::sqrt(1.2) * 0.1 / 0.25;
  const double between = std::sqrt(4.012) / 0.25 - 8;
  CHECK(found[0] == Approx(0.5 * (1 - within)));
  CHECK(found[1] == Approx(0.5 * within));
  CHECK(found[8] == Approx(0.5 * (1 - between)));
  CHECK(found[9] == Approx(0.5 * between));
}

TEST_CASE("the shares sum to 1") {
  const std::vector<double> found = pair_distances(random_balls(80, 4));
  CHECK(std::accumulate(found.begin(), found.end(), 0.0) == Approx(1.0));
}

TEST_CASE("the distance of two balls is the root mean square over their points") {
  // Integrated over both balls; a large weight on the pair makes its position readable.
  const Ball a{{0, 0, 0}, 0.5};
  const Ball b{{1.1, 0.3, -0.2}, 0.4};
  double sum = 0.0;
  double weights = 0.0;
  const auto directions = sphere_quadrature(4);
  const auto radii = gauss_legendre(4);
  for (const auto& [x, wx] : radii) {
    for (const auto& [y, wy] : radii) {
      const double s = a.radius * (1 + x) / 2;
      const double t = b.radius * (1 + y) / 2;
      for (const SpherePoint& u : directions) {
        for (const SpherePoint& v : directions) {
          const double weight = wx * s * s * u.weight * wy * t * t * v.weight;
          sum += weight * (a.center + s * u.direction - b.center - t * v.direction).squaredNorm();
          weights += weight;
        }
      }
    }
  }
  const double expected = std::sqrt(sum / weights) / 0.25;
  const std::vector<double> found = pair_distances(std::vector<Ball>{a, b});
  const auto lower = static_cast<std::size_t>(expected);
  CHECK(found[lower + 1] / (found[lower] + found[lower + 1]) ==
        Approx(expected - static_cast<double>(lower)));
}
