#include "evaluation/measures/statistics.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace mdbd;

TEST_CASE("quantiles interpolate between neighbours") {
  const std::vector<double> values = {40, 10, 30, 20};
  CHECK(mean(values) == 25);
  CHECK(quantile(values, 0) == 10);
  CHECK(quantile(values, 1) == 40);
  CHECK(quantile(values, 0.5) == 25);
  CHECK(quantile(values, 0.9) == Approx(37));
  CHECK(quantile({7}, 0.9) == 7);
}

TEST_CASE("rank correlation sees order only") {
  const std::vector<double> values = {1, 2, 3, 4, 5};
  CHECK(rank_correlation(values, {{1, 10, 11, 12, 1000}}) == Approx(1));
  CHECK(rank_correlation(values, {{5, 4, 3, 2, -9}}) == Approx(-1));
  // By 1 - 6 sum d^2 / (n (n^2 - 1)) with d = 1, 1, 0, 1, 1.
  CHECK(rank_correlation(values, {{2, 1, 3, 5, 4}}) == Approx(0.8));
  // Ranks 1.5, 1.5, 3 against 1, 2, 3.
  CHECK(rank_correlation(std::vector<double>{1, 1, 2}, std::vector<double>{1, 2, 3}) ==
        Approx(std::sqrt(0.75)));
}

TEST_CASE("rank correlation of nothing or of equal values is undefined") {
  CHECK_FALSE(rank_correlation({}, {}));
  CHECK_FALSE(rank_correlation(std::vector<double>{1}, std::vector<double>{1}));
  CHECK_FALSE(rank_correlation(std::vector<double>{1, 2}, std::vector<double>{3, 3}));
}
