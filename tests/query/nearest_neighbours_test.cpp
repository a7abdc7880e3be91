#include "query/nearest_neighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

#include "features/core/errors.h"

using mdbd::InvalidInput;
using mdbd::NearestNeighbours;
using mdbd::Neighbour;

namespace {

std::vector<float> random_values(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> value(-1.0F, 1.0F);
  std::vector<float> values(count);
  std::ranges::generate(values, [&] { return value(generator); });
  return values;
}

double distance(std::span<const float> a, std::span<const float> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(double{a[i]} - double{b[i]}, 2);
  return std::sqrt(sum);
}

}  // namespace

TEST_CASE("distances are those of a brute-force search, in increasing order") {
  constexpr std::size_t dimension = 7;
  constexpr std::size_t rows = 300;
  const auto k = GENERATE(std::size_t{1}, std::size_t{10}, std::size_t{300});
  const std::vector<float> values = random_values(rows * dimension, 1);
  const std::vector<float> query = random_values(dimension, 2);
  std::vector<double> expected;
  for (std::size_t row = 0; row < rows; ++row) {
    expected.push_back(distance(query, std::span(values).subspan(row * dimension, dimension)));
  }

  const std::vector<Neighbour> found = NearestNeighbours(values, dimension).search(query, k);

  REQUIRE(found.size() == k);
  for (const Neighbour& neighbour : found) {
    CHECK(neighbour.distance == Approx(expected[neighbour.row]).epsilon(1e-5));
  }
  std::ranges::sort(expected);
  for (std::size_t i = 0; i < k; ++i) {
    CHECK(found[i].distance == Approx(expected[i]).epsilon(1e-5));
  }
}

TEST_CASE("distances are not squared") {
  const NearestNeighbours neighbours({3.0F, 4.0F}, 2);
  CHECK(neighbours.search(std::vector{0.0F, 0.0F}, 1).at(0).distance == 5.0);
}

TEST_CASE("equal distances come in the order of the rows, whatever k is") {
  const NearestNeighbours neighbours(std::vector<float>(400, 1.0F), 1);
  const auto k = GENERATE(std::size_t{1}, std::size_t{5}, std::size_t{300}, std::size_t{400});
  const std::vector<Neighbour> found = neighbours.search(std::vector{0.5F}, k);
  REQUIRE(found.size() == k);
  for (std::size_t i = 0; i < k; ++i) CHECK(found[i].row == i);
}

TEST_CASE("a search for more rows than there are gives them all") {
  CHECK(NearestNeighbours({1.0F, 2.0F}, 1).search(std::vector{0.0F}, 12).size() == 2);
  CHECK(NearestNeighbours({}, 3).search(std::vector{0.0F, 0.0F, 0.0F}, 1).empty());
  CHECK(NearestNeighbours({1.0F}, 1).search(std::vector{0.0F}, 0).empty());
}

TEST_CASE("dimensions and values are checked") {
  CHECK_THROWS_AS(NearestNeighbours({}, 0), InvalidInput);
  CHECK_THROWS_AS(NearestNeighbours({1.0F, 2.0F, 3.0F}, 2), InvalidInput);
  const float bad = GENERATE(std::numeric_limits<float>::quiet_NaN(),
                             std::numeric_limits<float>::infinity(), -1e30F);
  CHECK_THROWS_AS(NearestNeighbours({0.0F, bad}, 2), InvalidInput);

  const NearestNeighbours neighbours({1.0F, 2.0F}, 2);
  CHECK_THROWS_AS(neighbours.search(std::vector{1.0F}, 1), InvalidInput);
  CHECK_THROWS_AS(neighbours.search(std::vector{1.0F, bad}, 1), InvalidInput);
}
