#include "evaluation/classifier/paper_features.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace mdbd;

namespace {

/// Balls in a row, each touching the next.
std::vector<Ball> make_chain(int count) {
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i) balls.push_back({{2.0 * i, 0, 0}, 1.0});
  return balls;
}

}  // namespace

TEST_CASE("the paper's features of a chain of balls, by hand") {
  // Radii 1 each, scaled by 4. p^0 is a third each; degrees are 1, 2, 1.
  const PaperFeatureOptions options{.radii = 4, .walk_balls = 2, .walk_steps = 2};
  const std::vector<double> features = paper_features(make_chain(3), 4.0, options);
  const std::vector<double> expected{0.25,        0.25,        0.25, 0.0,  // radii
                                     1.0 / 6,     2.0 / 3,                 // p^1
                                     1.0 / 3,     1.0 / 3,                 // p^2
                                     0.9 * 5 / 6, 0.81 * 2 / 3};           // sums
  REQUIRE(features.size() == expected.size());
  for (std::size_t i = 0; i < features.size(); ++i) CHECK(features[i] == Approx(expected[i]));
}

TEST_CASE("there are 130 features, whatever the number of balls") {
  for (const int count : {0, 1, 5, 19, 20, 50}) {
    const std::vector<double> features = paper_features(make_chain(count), 10.0);
    INFO(count << " balls");
    REQUIRE(features.size() == 130);
    for (int i = 0; i < 20; ++i) CHECK(features[i] == (i < count ? 0.1 : 0.0));
    for (int t = 0; t < 10; ++t) {
      double sum = 0.0;
      for (int i = 0; i < 10; ++i) sum += features[20 + 10 * t + i];
      CHECK(features[120 + t] == Approx(std::pow(0.9, t + 1) * sum));
    }
  }
}
