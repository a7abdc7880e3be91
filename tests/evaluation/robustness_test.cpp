#include "evaluation/measures/robustness.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "evaluation/measures/statistics.h"
#include "features/core/errors.h"
#include "features/core/random.h"

using namespace mdbd;

namespace {

/// Models on a line: one radius each, no walk.
RobustnessInput line(const std::vector<float>& clean, const std::vector<std::string>& labels,
                     const std::vector<std::optional<float>>& varied) {
  RobustnessInput input{.clean = {}, .labels = labels, .varied = {}, .terms = {{.count = 1}}};
  for (const float x : clean) input.clean.push_back({x});
  for (const auto& x : varied) {
    input.varied.push_back(x ? std::optional(std::vector<float>{*x}) : std::nullopt);
  }
  return input;
}

/// Twelve random models of three classes in four dimensions, two of them radii.
RobustnessInput random_input(std::uint64_t seed) {
  Random random(seed);
  const auto draw = [&](double size) { return static_cast<float>(random.uniform(-size, size)); };
  RobustnessInput input{.clean = {},
                        .labels = {},
                        .varied = {},
                        .terms = {{.count = 2}, {.first = 2, .count = 2, .weight = 0.7}}};
  for (int i = 0; i < 12; ++i) {
    std::vector<float> clean = {draw(1), draw(1), draw(1), draw(1)};
    std::vector<float> varied = clean;
    for (float& x : varied) x += draw(0.6);
    input.clean.push_back(clean);
    input.labels.push_back(std::string(1, static_cast<char>('a' + i % 3)));
    input.varied.push_back(varied);
  }
  input.clean[4] = input.clean[1];  // a duplicate
  input.varied[7].reset();
  return input;
}

double distance(const RobustnessInput& input, const std::vector<float>& f,
                const std::vector<float>& g) {
  const auto square = [&](std::size_t i) { return std::pow(double{f[i]} - double{g[i]}, 2); };
  return std::sqrt(square(0) + square(1)) +
         input.terms[1].weight * std::sqrt(square(2) + square(3));
}

}  // namespace

TEST_CASE("robustness by hand") {
  const auto result =
      measure_robustness(line({0, 1, 10, 12}, {"a", "a", "b", "b"}, {0.1F, 0.8F, 10.5F, 1.5F}));
  REQUIRE(result.models.size() == 4);
  CHECK(result.models[0].self_rank == 1);
  CHECK(result.models[0].displacement == Approx(0.1));
  CHECK(*result.models[0].relative_displacement == Approx(0.1));
  CHECK(*result.models[2].relative_displacement == Approx(0.25));
  CHECK(result.models[3].self_rank == 4);  // 1, 0 and 10 are nearer to 1.5 than 12
  CHECK(result.self_first == 0.75);
  CHECK(*result.class_accuracy == 0.75);  // 1.5 is nearest to 1, of class a
  CHECK(*result.models[0].rank_correlation == Approx(1));
  CHECK(*result.rank_correlation_mean <= 1);
  CHECK(*result.rank_correlation_min == Approx(-0.5));  // from 1.5: 1, 0, 10 instead of 10, 1, 0
  CHECK(result.mean_shift[0] == Approx((0.1 - 0.2 + 0.5 - 10.5) / 4));
  CHECK(result.mean_absolute_shift[0] == Approx((0.1 + 0.2 + 0.5 + 10.5) / 4));
}

TEST_CASE("duplicates are not punished") {
  const auto result = measure_robustness(line({0, 0, 0, 1}, {"a", "a", "b", "b"}, {0, 0, 0, 0.9F}));
  for (int i = 0; i < 3; ++i) {
    CHECK(result.models[i].self_rank == 1);
    CHECK(*result.models[i].relative_displacement == 0);  // relative to the model at 1
  }
  CHECK(result.self_first == 1);
  // Of equally near models the first counts.
  CHECK(result.models[0].is_class_found == true);
  CHECK(result.models[2].is_class_found == false);
}

TEST_CASE("what cannot be told is empty") {
  const auto alone = measure_robustness(line({1}, {"a"}, {1.5F}));
  CHECK(alone.self_first == 1);
  CHECK(alone.models[0].displacement == 0.5);
  CHECK_FALSE(alone.class_accuracy);
  CHECK_FALSE(alone.rank_correlation_mean);
  CHECK_FALSE(alone.displacement_median);

  const auto pair = measure_robustness(line({1, 1}, {"a", "b"}, {2, std::nullopt}));
  CHECK(pair.models.size() == 1);
  CHECK_FALSE(pair.class_accuracy);  // both are alone in their class
  CHECK_FALSE(pair.displacement_mean);
}

TEST_CASE("inconsistent input is refused") {
  CHECK_THROWS_AS(measure_robustness(line({1, 2}, {"a"}, {1, 2})), InvalidInput);
  CHECK_THROWS_AS(measure_robustness(line({1, 2}, {"a", "a"}, {1})), InvalidInput);
  CHECK_THROWS_AS(measure_robustness(line({1, 2}, {"a", "a"}, {{}, {}})), InvalidInput);
  CHECK_THROWS_AS(measure_robustness({}), InvalidInput);
  RobustnessInput ragged = line({1, 2}, {"a", "a"}, {1, 2});
  ragged.varied[1] = {{1, 2}};
  CHECK_THROWS_AS(measure_robustness(ragged), InvalidInput);
}

TEST_CASE("unchanged models are where they were") {
  RobustnessInput input = random_input(1);
  for (std::size_t i = 0; i < input.clean.size(); ++i) input.varied[i] = input.clean[i];
  const Robustness result = measure_robustness(input);
  CHECK(result.self_first == 1);
  CHECK(*result.rank_correlation_min == Approx(1));
  CHECK(*result.displacement_90 == 0);
  for (const double shift : result.mean_absolute_shift) CHECK(shift == 0);
}

TEST_CASE("robustness equals what the definitions say, model by model") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RobustnessInput input = random_input(seed);
    const Robustness result = measure_robustness(input);
    REQUIRE(result.models.size() == 11);
    std::vector<double> relative;
    int first = 0;
    int found = 0;
    for (const ModelRobustness& model : result.models) {
      const std::vector<float>& varied = *input.varied[model.model];
      const std::vector<float>& clean = input.clean[model.model];
      const double self = distance(input, varied, clean);
      double nearest_clean = 1e9;
      double nearest = 1e9;
      std::string label;
      std::size_t rank = 1;
      std::vector<double> before;
      std::vector<double> after;
      for (std::size_t j = 0; j < input.clean.size(); ++j) {
        if (j == model.model) continue;
        before.push_back(distance(input, clean, input.clean[j]));
        after.push_back(distance(input, varied, input.clean[j]));
        if (after.back() < self) ++rank;
        if (after.back() < nearest) {
          nearest = after.back();
          label = input.labels[j];
        }
        if (before.back() > 0) nearest_clean = std::min(nearest_clean, before.back());
      }
      CHECK(model.self_rank == rank);
      CHECK(model.displacement == Approx(self));
      CHECK(*model.relative_displacement == Approx(self / nearest_clean));
      CHECK(*model.is_class_found == (label == input.labels[model.model]));
      CHECK(*model.rank_correlation == Approx(*rank_correlation(before, after)));
      relative.push_back(self / nearest_clean);
      first += rank == 1 ? 1 : 0;
      found += label == input.labels[model.model] ? 1 : 0;
    }
    CHECK(result.self_first == Approx(first / 11.0));
    CHECK(*result.class_accuracy == Approx(found / 11.0));
    CHECK(*result.displacement_median == Approx(quantile(relative, 0.5)));
    CHECK(*result.displacement_90 == Approx(quantile(relative, 0.9)));
  }
}
