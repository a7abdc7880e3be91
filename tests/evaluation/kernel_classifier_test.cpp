#include "evaluation/classifier/kernel_classifier.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/core/random.h"

using namespace mdbd;
using Catch::Matchers::Contains;

namespace {

/// Points of two rings around the origin, which no line parts.
LabelledRows rings(int count, std::uint64_t seed) {
  Random random(seed);
  LabelledRows data;
  for (int i = 0; i < count; ++i) {
    const std::size_t label = i % 2;
    const double radius = (label == 0 ? 1.0 : 2.0) + random.uniform(-0.2, 0.2);
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    data.rows.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    data.labels.push_back(label);
  }
  return data;
}

std::size_t wrong(const std::vector<std::size_t>& found, const LabelledRows& data) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < found.size(); ++i) count += found[i] != data.labels[i] ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("the kernel parts rings that no line parts") {
  const LabelledRows unknown = rings(200, 3);
  CHECK(wrong(classify_by_kernel(rings(100, 1), rings(30, 2), 2, unknown.rows), unknown) == 0);
}

TEST_CASE("two points with known weights: the value is that of the nearer one") {
  const LabelledRows training{.rows = {{0.0}, {1.0}}, .labels = {0, 1}};
  const std::vector<std::vector<double>> rows{{-5.0}, {0.4}, {0.6}, {5.0}};
  CHECK(classify_by_kernel(training, {}, 2, rows) == std::vector<std::size_t>{0, 0, 1, 1});
}

TEST_CASE("the validation rows choose the width") {
  // Ten alternating points on a line: a wide kernel with a large ridge sees one class only.
  LabelledRows training;
  for (int i = 0; i < 10; ++i) {
    training.rows.push_back({static_cast<double>(i)});
    training.labels.push_back(i % 2);
  }
  const KernelClassifierOptions options{.widths = {100.0, 0.02}, .ridges = {1.0}};
  CHECK(wrong(classify_by_kernel(training, {}, 2, training.rows, options), training) > 0);
  CHECK(wrong(classify_by_kernel(training, training, 2, training.rows, options), training) == 0);
}

TEST_CASE("equal training rows, classes that do not occur and a single row do no harm") {
  const LabelledRows equal{.rows = {{1.0}, {1.0}, {1.0}}, .labels = {2, 2, 2}};
  const std::vector<std::vector<double>> rows{{1.0}};
  CHECK(classify_by_kernel(equal, {}, 4, rows) == std::vector<std::size_t>{2});
  const LabelledRows one{.rows = {{1.0}}, .labels = {1}};
  CHECK(classify_by_kernel(one, {}, 2, rows) == std::vector<std::size_t>{1});
}

TEST_CASE("what the kernel classifier cannot use is said") {
  const std::vector<std::vector<double>> rows{{1.0}};
  const LabelledRows one{.rows = {{1.0}}, .labels = {1}};
  CHECK_THROWS_WITH(classify_by_kernel({}, {}, 2, rows), Contains("no rows to train on"));
  CHECK_THROWS_WITH(classify_by_kernel(one, {}, 1, rows), Contains("label"));
  CHECK_THROWS_WITH(classify_by_kernel(one, {.rows = {{1.0, 2.0}}, .labels = {0}}, 2, rows),
                    Contains("differ in length"));
  CHECK_THROWS_AS(classify_by_kernel(one, {}, 2, rows, {.widths = {}}), InvalidInput);
  CHECK_THROWS_AS(classify_by_kernel(one, {}, 2, rows, {.ridges = {0.0}}), InvalidInput);
}
