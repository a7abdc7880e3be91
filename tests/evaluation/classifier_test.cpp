#include "evaluation/classifier/classifier.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/core/random.h"

using namespace mdbd;

namespace {

/// Points in four corners; opposite corners are of one class. No line separates them.
LabelledRows make_xor(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  LabelledRows data;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_right = i % 2 == 0;
    const bool is_high = i / 2 % 2 == 0;
    data.rows.push_back({1000 + (is_right ? 1 : -1) + random.uniform(-0.5, 0.5),
                         1e-3 * ((is_high ? 1 : -1) + random.uniform(-0.5, 0.5))});
    data.labels.push_back(is_right == is_high ? 0 : 1);
  }
  return data;
}

/// Three groups on a line, far apart.
LabelledRows make_groups(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  LabelledRows data;
  for (std::size_t i = 0; i < count; ++i) {
    data.rows.push_back({static_cast<double>(i % 3) + random.uniform(-0.2, 0.2)});
    data.labels.push_back(i % 3);
  }
  return data;
}

void add_column(LabelledRows& data, double value) {
  for (auto& row : data.rows) row.push_back(value);
}

}  // namespace

TEST_CASE("the network learns what no line separates, whatever the scale of its inputs") {
  const Classifier classifier = train_classifier(make_xor(80, 1), make_xor(40, 2), 2, {}, 3);
  const LabelledRows test = make_xor(200, 4);
  CHECK(classifier.predict(test.rows) == test.labels);
  CHECK(classifier.epochs() > 0);
}

TEST_CASE("probabilities sum to one and the largest one is predicted") {
  const Classifier classifier = train_classifier(make_groups(60, 1), make_groups(30, 2), 3, {}, 3);
  const LabelledRows test = make_groups(90, 4);
  const auto probabilities = classifier.probabilities(test.rows);
  const auto predicted = classifier.predict(test.rows);
  REQUIRE(probabilities.size() == 90);
  CHECK(predicted == test.labels);
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const auto& p = probabilities[i];
    REQUIRE(p.size() == 3);
    CHECK(p[0] + p[1] + p[2] == Approx(1.0));
    for (const double other : p) CHECK(p[predicted[i]] >= other);
  }
  CHECK(classifier.predict({}).empty());
}

TEST_CASE("the same seed trains the same network, another seed another one") {
  const LabelledRows training = make_xor(80, 1);
  const LabelledRows validation = make_xor(40, 2);
  const auto outputs = [&](std::uint64_t seed) {
    return train_classifier(training, validation, 2, {}, seed).probabilities(validation.rows);
  };
  const auto first = outputs(5);
  std::srand(99);  // which dlib draws from
  CHECK(outputs(5) == first);
  CHECK(outputs(6) != first);
}

TEST_CASE("columns that are constant in training change nothing") {
  LabelledRows training = make_groups(60, 1);
  LabelledRows validation = make_groups(30, 2);
  LabelledRows test = make_groups(90, 4);
  for (LabelledRows* data : {&training, &validation}) {
    add_column(*data, 0.0);
    add_column(*data, 0.1);
  }
  add_column(test, 7.0);
  add_column(test, -1e30);
  const Classifier classifier = train_classifier(training, validation, 3, {}, 3);
  CHECK(classifier.predict(test.rows) == test.labels);
}

TEST_CASE("a class without training rows is not predicted") {
  LabelledRows training;
  const LabelledRows all = make_groups(60, 1);
  for (std::size_t i = 0; i < all.rows.size(); ++i) {
    if (all.labels[i] == 1) continue;
    training.rows.push_back(all.rows[i]);
    training.labels.push_back(all.labels[i]);
  }
  const Classifier classifier = train_classifier(training, all, 3, {}, 3);
  for (const std::size_t label : classifier.predict(training.rows)) CHECK(label != 1);
}

TEST_CASE("one class alone, and a single row without validation") {
  const LabelledRows one{{{1.0, 2.0}}, {0}};
  const Classifier classifier = train_classifier(one, {}, 1, {}, 3);
  CHECK(classifier.predict(one.rows) == std::vector<std::size_t>{0});
  CHECK(classifier.probabilities(one.rows).at(0).at(0) == Approx(1.0));
}

TEST_CASE("training stops when the validation loss falls no more") {
  LabelledRows validation = make_groups(30, 2);
  for (std::size_t& label : validation.labels) label = (label + 1) % 3;  // the better, the worse
  ClassifierOptions options;
  options.patience = 5;
  options.maximum_epochs = 1000;
  const Classifier classifier = train_classifier(make_groups(60, 1), validation, 3, options, 3);
  CHECK(classifier.epochs() < 50);
}

TEST_CASE("what cannot be trained on or predicted is refused") {
  const LabelledRows good = make_groups(9, 1);
  const auto train = [](const LabelledRows& training, const LabelledRows& validation = {},
                        std::size_t classes = 3, const ClassifierOptions& options = {}) {
    return train_classifier(training, validation, classes, options, 1);
  };
  CHECK_THROWS_AS(train({}), InvalidInput);
  CHECK_THROWS_AS(train({{{}}, {0}}), InvalidInput);
  CHECK_THROWS_AS(train({{{1.0}, {1.0, 2.0}}, {0, 1}}), InvalidInput);
  CHECK_THROWS_AS(train({{{1.0}}, {0, 1}}), InvalidInput);
  CHECK_THROWS_AS(train({{{std::numeric_limits<double>::quiet_NaN()}}, {0}}), InvalidInput);
  CHECK_THROWS_AS(train(good, {{{1.0, 2.0}}, {0}}), InvalidInput);
  CHECK_THROWS_AS(train(good, {}, 2), InvalidInput);
  ClassifierOptions options;
  options.hidden_neurons = 0;
  CHECK_THROWS_AS(train(good, {}, 3, options), InvalidInput);
  const std::vector<std::vector<double>> too_long{{1.0, 2.0}};
  CHECK_THROWS_AS(train(good).predict(too_long), InvalidInput);
}
