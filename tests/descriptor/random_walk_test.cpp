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

void check_close(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(values[i] == Approx(expected[i]));
}

}  // namespace

TEST_CASE("on a single edge the two probabilities change places") {
  const RandomWalk walk = random_walk({{{1}, {0}}}, balls_of({3.0, 1.0}), 4);
  REQUIRE(walk.is_defined);
  REQUIRE(walk.distributions.size() == 4);
  for (int t = 1; t <= 4; ++t) {
    const bool is_even = t % 2 == 0;
    check_close(walk.distributions[t - 1], {is_even ? 0.75 : 0.25, is_even ? 0.25 : 0.75});
  }
}

TEST_CASE("on a star the centre hands its mass to the leaves in equal parts") {
  const ContactGraph graph{{{1, 2, 3, 4}, {0}, {0}, {0}, {0}}};
  const RandomWalk walk = random_walk(graph, balls_of({4.0, 1.0, 1.0, 1.0, 1.0}), 3);
  REQUIRE(walk.distributions.size() == 3);
  for (const auto& distribution : walk.distributions) {
    check_close(distribution, {0.5, 0.125, 0.125, 0.125, 0.125});
  }
}

TEST_CASE("balls without contacts lose their mass, the rest is scaled to one") {
  const RandomWalk walk = random_walk({{{}, {2}, {1}}}, balls_of({6.0, 3.0, 1.0}), 2);
  CHECK(walk.is_defined);
  check_close(walk.distributions.at(0), {0.0, 0.25, 0.75});
  check_close(walk.distributions.at(1), {0.0, 0.75, 0.25});
}

TEST_CASE("an uneven walk by hand: a path of three balls with a fourth in the middle") {
  // p^0 = (4, 3, 2, 1) / 10; the degrees are 1, 3, 1, 1.
  const RandomWalk walk =
      random_walk({{{1}, {0, 2, 3}, {1}, {1}}}, balls_of({4.0, 3.0, 2.0, 1.0}), 2);
  check_close(walk.distributions.at(0), {0.1, 0.7, 0.1, 0.1});
  check_close(walk.distributions.at(1), {0.7 / 3, 0.3, 0.7 / 3, 0.7 / 3});
}

TEST_CASE("sums count the first balls and are damped by a power of lambda") {
  const RandomWalk walk{{{0.5, 0.2, 0.3}, {0.1, 0.6, 0.3}}, true};
  check_close(walk_sums(walk, 1, 1.0), {0.5, 0.1});
  check_close(walk_sums(walk, 2, 0.5), {0.5 * 0.7, 0.25 * 0.7});
}

TEST_CASE("counting all balls gives the damping alone") {
  const ContactGraph graph{{{1, 2}, {0, 2}, {0, 1}}};
  const RandomWalk walk = random_walk(graph, balls_of({5.0, 2.0, 1.0}), 50);
  const std::vector<double> sums = walk_sums(walk, 50, 0.9);
  REQUIRE(sums.size() == 50);
  for (int t = 1; t <= 50; ++t) CHECK(sums[t - 1] == Approx(std::pow(0.9, t)));
}

TEST_CASE("without edges the walk is undefined and zero") {
  const RandomWalk walk = random_walk({{{}, {}}}, balls_of({2.0, 1.0}), 3);
  CHECK_FALSE(walk.is_defined);
  CHECK(walk.distributions == std::vector<std::vector<double>>(3, {0.0, 0.0}));
  CHECK(walk_sums(walk, 2, 0.9) == std::vector<double>{0, 0, 0});
  const RandomWalk empty = random_walk({}, {}, 3);
  CHECK_FALSE(empty.is_defined);
  CHECK(walk_sums(empty, 2, 0.9) == std::vector<double>{0, 0, 0});
}
