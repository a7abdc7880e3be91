#include "features/decomposition/max_min_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

double minimum_at(const std::vector<AffineFunction>& functions, const Eigen::Vector3d& point) {
  double minimum = std::numeric_limits<double>::infinity();
  for (const AffineFunction& f : functions)
    minimum = std::min(minimum, f.offset + f.slope.dot(point));
  return minimum;
}

std::vector<AffineFunction> random_functions(std::mt19937& random, int count) {
  std::normal_distribution<double> normal;
  std::vector<AffineFunction> functions;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d slope(normal(random), normal(random), normal(random));
    functions.push_back({1.0 + 0.1 * normal(random), slope.normalized()});
  }
  return functions;
}

}  // namespace

TEST_CASE("the value of a max-min programme is attained and never exceeded") {
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    const int count = 1 + round % max_min_capacity;
    std::vector<AffineFunction> functions = random_functions(random, count);
    if (round % 5 == 0) functions.back() = functions.front();  // degenerate
    const double half_size = 0.01 + 0.5 * (round % 7);
    const MaxMinSolution solution = maximise_minimum(functions, half_size);
    REQUIRE(solution.point.lpNorm<Eigen::Infinity>() <= half_size * (1 + 1e-9));
    REQUIRE(std::abs(minimum_at(functions, solution.point) - solution.value) <= 1e-11);
    for (int i = 0; i < 50; ++i) {
      Eigen::Vector3d point = random_point(random, half_size);
      if (i % 2 == 0) point = solution.point + 0.01 * point;
      point = point.cwiseMax(-half_size).cwiseMin(half_size);
      REQUIRE(minimum_at(functions, point) <= solution.value + 1e-11);
    }
  }
}

TEST_CASE("the binding functions alone give the value") {
  std::mt19937 random(2);
  for (int round = 0; round < 500; ++round) {
    const std::vector<AffineFunction> functions = random_functions(random, 12);
    const MaxMinSolution solution = maximise_minimum(functions, 0.5);
    std::vector<AffineFunction> binding;
    for (std::size_t i = 0; i < functions.size(); ++i) {
      if ((solution.binding >> i & 1U) != 0) binding.push_back(functions[i]);
    }
    REQUIRE_FALSE(binding.empty());
    REQUIRE(std::abs(maximise_minimum(binding, 0.5).value - solution.value) <= 1e-11);
  }
}

TEST_CASE("max-min programmes with known answers") {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  SECTION("one function rises to the corner") {
    const std::vector<AffineFunction> functions{{1.0, x}};
    CHECK(maximise_minimum(functions, 0.25).value == Approx(1.25));
  }
  SECTION("two opposite functions meet half way") {
    const std::vector<AffineFunction> functions{{1.0, x}, {1.2, -x}};
    const MaxMinSolution solution = maximise_minimum(functions, 1.0);
    CHECK(solution.value == Approx(1.1));
    CHECK(solution.point.x() == Approx(0.1));
  }
  SECTION("a constant caps the others") {
    const std::vector<AffineFunction> functions{{1.0, x}, {0.5, Eigen::Vector3d::Zero()}};
    CHECK(maximise_minimum(functions, 1.0).value == Approx(0.5));
  }
}
