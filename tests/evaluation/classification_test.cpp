#include "evaluation/measures/classification.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

std::size_t count(const std::vector<Part>& parts, Part part) {
  return static_cast<std::size_t>(std::ranges::count(parts, part));
}

}  // namespace

TEST_CASE("70 % train, 15 % validate, 15 % test") {
  for (const auto& [models, validation, test] : std::vector<std::array<std::size_t, 3>>{
           {900, 135, 135}, {448, 67, 67}, {7, 1, 1}, {2, 0, 0}}) {
    const std::vector<Part> parts = split_at_random(models, 1);
    CHECK(parts.size() == models);
    CHECK(count(parts, Part::validation) == validation);
    CHECK(count(parts, Part::test) == test);
  }
}

TEST_CASE("every model comes into the test part equally often, and a seed repeats its division") {
  CHECK(split_at_random(100, 5) == split_at_random(100, 5));
  CHECK(split_at_random(100, 5) != split_at_random(100, 6));
  std::vector<int> tests(20, 0);
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    const std::vector<Part> parts = split_at_random(20, seed);
    for (std::size_t i = 0; i < 20; ++i) tests[i] += parts[i] == Part::test ? 1 : 0;
  }
  for (const int number : tests) CHECK(std::abs(number - 600) < 120);  // five deviations
}

TEST_CASE("confusions are counted for a part and for all") {
  const std::vector<std::size_t> labels{0, 0, 1, 1, 2};
  const std::vector<std::size_t> predicted{0, 1, 1, 1, 0};
  const std::vector<Part> parts{Part::training, Part::test, Part::test, Part::validation,
                                Part::test};
  const ConfusionCounts all = count_confusions(labels, predicted, parts, std::nullopt, 3);
  CHECK(all == ConfusionCounts{{1, 1, 0}, {0, 2, 0}, {1, 0, 0}});
  CHECK(accuracy(all) == 0.6);
  ConfusionCounts test = count_confusions(labels, predicted, parts, Part::test, 3);
  CHECK(test == ConfusionCounts{{0, 1, 0}, {0, 1, 0}, {1, 0, 0}});
  CHECK(accuracy(test) == 1.0 / 3);
  add_counts(test, all);
  CHECK(test == ConfusionCounts{{1, 2, 0}, {0, 3, 0}, {2, 0, 0}});
}

TEST_CASE("the spread of several runs") {
  const Spread spread = spread_of(std::vector{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0});
  CHECK(spread.mean == 5.0);
  CHECK(spread.deviation == Approx(std::sqrt(32.0 / 7)));
  CHECK(spread.lowest == 2.0);
  CHECK(spread.highest == 9.0);
  CHECK(spread_of(std::vector{3.0}).deviation == 0.0);
}
