#include "features/descriptor/random_walk.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

std::vector<Ball> balls_of(const std::vector<double>& radii) {
  std::vector<Ball> balls;
  for (const double radius : radii) balls.push_back({{0, 0, 0}, radius});
  return balls;
}

}  // namespace

TEST_CASE("on a single edge the two probabilities change places") {
  const ContactGraph graph{{{1}, {0}}};
  const WalkSums walk = walk_sums(graph, balls_of({3.0, 1.0}), 1, 4, 0.9);
  REQUIRE(walk.is_defined);
  const std::vector<double> expected{0.25, 0.75, 0.25, 0.75};
  for (int t = 1; t <= 4; ++t) {
    CHECK(walk.sums[t - 1] == Approx(std::pow(0.9, t) * expected[t - 1]));
  }
}

TEST_CASE("on a star the centre hands its mass to the leaves in equal parts") {
  const ContactGraph graph{{{1, 2, 3, 4}, {0}, {0}, {0}, {0}}};
  const std::vector<Ball> balls = balls_of({4.0, 1.0, 1.0, 1.0, 1.0});
  const WalkSums center = walk_sums(graph, balls, 1, 3, 1.0);
  for (const double sum : center.sums) CHECK(sum == Approx(0.5));
  const WalkSums three = walk_sums(graph, balls, 3, 1, 1.0);
  CHECK(three.sums[0] == Approx(0.5 + 2 * 0.125));
}

TEST_CASE("balls without contacts lose their mass, the rest is scaled to one") {
  const ContactGraph graph{{{}, {2}, {1}}};
  const WalkSums walk = walk_sums(graph, balls_of({6.0, 3.0, 1.0}), 2, 2, 1.0);
  CHECK(walk.is_defined);
  CHECK(walk.sums[0] == Approx(0.25));
  CHECK(walk.sums[1] == Approx(0.75));
}

TEST_CASE("counting all balls gives the damping alone") {
  const ContactGraph graph{{{1, 2}, {0, 2}, {0, 1}}};
  const WalkSums walk = walk_sums(graph, balls_of({5.0, 2.0, 1.0}), 50, 50, 0.9);
  REQUIRE(walk.sums.size() == 50);
  for (int t = 1; t <= 50; ++t) CHECK(walk.sums[t - 1] == Approx(std::pow(0.9, t)));
}

TEST_CASE("without edges the walk is undefined and zero") {
  const WalkSums walk = walk_sums({{{}, {}}}, balls_of({2.0, 1.0}), 2, 3, 0.9);
  CHECK_FALSE(walk.is_defined);
  CHECK(walk.sums == std::vector<double>{0, 0, 0});
  CHECK_FALSE(walk_sums({}, {}, 2, 3, 0.9).is_defined);
}
