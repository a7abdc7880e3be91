#include "evaluation/measures/retrieval_measures.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/core/random.h"

using namespace mdbd;

namespace {

using Labels = std::vector<std::string>;

/// Distances between points on a line.
DistanceMatrix line(const std::vector<double>& points) {
  DistanceMatrix distances(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      distances(i, j) = std::abs(points[i] - points[j]);
    }
  }
  return distances;
}

DistanceMatrix random_distances(std::size_t size, std::uint64_t seed) {
  Random random(seed);
  DistanceMatrix distances(size);
  for (std::size_t i = 0; i < size; ++i) {
    // Few values, so that there are ties.
    for (std::size_t j = 0; j < size; ++j) {
      distances(i, j) = static_cast<double>(random.index(size / 2));
    }
  }
  return distances;
}

/// The rank of a model in the answer to a query, from 1, without sorting.
std::size_t rank_of(const DistanceMatrix& d, std::size_t query, std::size_t model) {
  std::size_t rank = 1;
  for (std::size_t other = 0; other < d.size(); ++other) {
    if (other == query || other == model) continue;
    const bool is_before =
        d(query, other) < d(query, model) || (d(query, other) == d(query, model) && other < model);
    rank += is_before ? 1 : 0;
  }
  return rank;
}

/// The scores of one query from the ranks of its class alone.
RetrievalScores brute_force(const DistanceMatrix& d, const Labels& labels, std::size_t query) {
  std::vector<double> ranks;
  for (std::size_t model = 0; model < labels.size(); ++model) {
    if (model != query && labels[model] == labels[query]) {
      ranks.push_back(static_cast<double>(rank_of(d, query, model)));
    }
  }
  const double relevant = static_cast<double>(ranks.size());
  const auto found = [&](double rank) {
    double count = 0;
    for (const double r : ranks) count += r <= rank ? 1 : 0;
    return count;
  };
  const double answers = static_cast<double>(d.size() - 1);
  RetrievalScores scores;
  scores.nearest_neighbour = found(1);
  scores.first_tier = found(relevant) / relevant;
  scores.second_tier = found(2 * relevant) / relevant;
  // 2 / (1/P + 1/R) = 2 hits / (answers + relevant)
  scores.e_measure = 2 * found(32) / (std::min(32.0, answers) + relevant);
  double best = 0;
  for (double i = 1; i <= relevant; ++i) best += 1 / std::max(1.0, std::log2(i));
  for (const double rank : ranks) {
    scores.discounted_gain += 1 / std::max(1.0, std::log2(rank)) / best;
    scores.average_precision += found(rank) / rank / relevant;
  }
  for (std::size_t level = 0; level < recall_levels; ++level) {
    for (double rank = 1; rank <= answers; ++rank) {
      if (found(rank) * 20 >= static_cast<double>(level + 1) * relevant) {
        scores.precision[level] = std::max(scores.precision[level], found(rank) / rank);
      }
    }
  }
  return scores;
}

std::vector<double> as_list(const RetrievalScores& scores) {
  std::vector<double> list = {scores.nearest_neighbour, scores.first_tier,
                              scores.second_tier,       scores.e_measure,
                              scores.discounted_gain,   scores.average_precision};
  list.insert(list.end(), scores.precision.begin(), scores.precision.end());
  return list;
}

}  // namespace

TEST_CASE("a perfect ranking scores 1") {
  const RetrievalMeasures measures =
      measure_retrieval(line({0, 1, 2, 100, 101, 102, 103}), {"a", "a", "a", "b", "b", "b", "b"});
  CHECK(measures.queries == 7);
  CHECK(measures.left_out == 0);
  CHECK(measures.mean.nearest_neighbour == 1.0);
  CHECK(measures.mean.first_tier == 1.0);
  CHECK(measures.mean.second_tier == 1.0);
  CHECK(measures.mean.discounted_gain == Approx(1.0));
  CHECK(measures.mean.average_precision == 1.0);
  for (const double precision : measures.mean.precision) CHECK(precision == 1.0);
  // Six answers with all relevant among them: P = 2/6 or 3/6, R = 1.
  CHECK(measures.classes[0].mean.e_measure == Approx(0.5));
  CHECK(measures.classes[1].mean.e_measure == Approx(2.0 / 3));
}

TEST_CASE("a class of 33 that is found first has the E-measure 1") {
  std::vector<double> points;
  Labels labels;
  for (int i = 0; i < 66; ++i) {
    points.push_back(i + (i < 33 ? 0 : 1000));
    labels.push_back(i < 33 ? "a" : "b");
  }
  CHECK(measure_retrieval(line(points), labels).mean.e_measure == Approx(1.0));
}

TEST_CASE("a ranking with every model of the class last has the least scores") {
  DistanceMatrix distances(6);
  const Labels labels = {"a", "a", "a", "b", "b", "b"};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) distances(i, j) = labels[i] == labels[j] ? 2.0 : 1.0;
  }
  const RetrievalScores scores = measure_retrieval(distances, labels).mean;
  CHECK(scores.nearest_neighbour == 0.0);
  CHECK(scores.first_tier == 0.0);
  CHECK(scores.second_tier == 0.5);  // the fourth of five answers
  CHECK(scores.average_precision == Approx((1.0 / 4 + 2.0 / 5) / 2));
  CHECK(scores.discounted_gain == Approx((1 / std::log2(4) + 1 / std::log2(5)) / 2));
  CHECK(scores.precision.front() == Approx(0.4));
}

TEST_CASE("an example computed by hand") {
  // The query 0 sees a b a b b: hits at ranks 1 and 3 of two relevant models.
  const RetrievalMeasures measures =
      measure_retrieval(line({0, 1, 2, 3, 4.5, 5.5}), {"a", "a", "b", "a", "b", "b"});
  const DistanceMatrix distances = line({0, 1, 2, 3, 4.5, 5.5});
  CHECK(rank_models(distances, 0) == std::vector<std::size_t>{1, 2, 3, 4, 5});
  CHECK(rank_models(distances, 1) == std::vector<std::size_t>{0, 2, 3, 4, 5});
  CHECK(rank_models(distances, 3) == std::vector<std::size_t>{2, 4, 1, 5, 0});
  const RetrievalScores a = measures.classes[0].mean;
  CHECK(a.nearest_neighbour == Approx(2.0 / 3));
  CHECK(a.first_tier == Approx((0.5 + 0.5 + 0) / 3));
  CHECK(a.second_tier == Approx((1 + 1 + 0.5) / 3));
  CHECK(a.e_measure == Approx(4.0 / 7));
  const double best = 2.0;
  const double third = 1 / std::log2(3);
  CHECK(a.discounted_gain ==
        Approx(((1 + third) / best + (1 + third) / best + (third + 1 / std::log2(5)) / best) / 3));
  CHECK(a.average_precision == Approx((5.0 / 6 + 5.0 / 6 + (1.0 / 3 + 2.0 / 5) / 2) / 3));
  CHECK(a.precision[0] == Approx((1 + 1 + 0.4) / 3));
  CHECK(a.precision[9] == Approx((1 + 1 + 0.4) / 3));  // one of two is a recall of 10/20
  CHECK(a.precision[10] == Approx((2.0 / 3 + 2.0 / 3 + 0.4) / 3));
}

TEST_CASE("scores agree with a brute-force computation") {
  for (const std::size_t size : {2, 5, 17, 60, 90}) {
    Random random(size);
    Labels labels = {"a", "a"};
    while (labels.size() < size) labels.push_back(std::string(1, "abcde"[random.index(5)]));
    const DistanceMatrix distances = random_distances(size, size + 1);
    const RetrievalMeasures measures = measure_retrieval(distances, labels);

    std::vector<double> mean(as_list({}).size());
    std::vector<double> class_mean(mean.size());
    for (const ClassRetrieval& found : measures.classes) {
      std::vector<double> expected(mean.size());
      for (std::size_t query = 0; query < size; ++query) {
        if (labels[query] != found.label) continue;
        const std::vector<double> scores = as_list(brute_force(distances, labels, query));
        for (std::size_t i = 0; i < mean.size(); ++i) {
          expected[i] += scores[i] / static_cast<double>(found.models);
          mean[i] += scores[i] / static_cast<double>(measures.queries);
        }
      }
      for (std::size_t i = 0; i < mean.size(); ++i) {
        CHECK(as_list(found.mean)[i] == Approx(expected[i]).margin(1e-12));
        class_mean[i] += expected[i] / static_cast<double>(measures.classes.size());
      }
    }
    for (std::size_t i = 0; i < mean.size(); ++i) {
      CHECK(as_list(measures.mean)[i] == Approx(mean[i]).margin(1e-12));
      CHECK(as_list(measures.class_mean)[i] == Approx(class_mean[i]).margin(1e-12));
    }
  }
}

TEST_CASE("a model alone in its class answers but does not query") {
  const RetrievalMeasures measures = measure_retrieval(line({0, 1, 3}), {"a", "alone", "a"});
  CHECK(measures.queries == 2);
  CHECK(measures.left_out == 1);
  CHECK(measures.mean.nearest_neighbour == 0.0);
  REQUIRE(measures.classes.size() == 1);
  CHECK(measures.classes[0].label == "a");
}

TEST_CASE("equal distances are ordered as the models are") {
  CHECK(rank_models(DistanceMatrix(4), 2) == std::vector<std::size_t>{0, 1, 3});
}

TEST_CASE("distances that are no numbers, and labels that do not fit, are refused") {
  DistanceMatrix distances = line({0, 1, 2});
  CHECK_THROWS_AS(measure_retrieval(distances, {"a", "a"}), InvalidInput);
  CHECK_THROWS_AS(measure_retrieval(distances, {"a", "b", "c"}), InvalidInput);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    distances(2, 1) = bad;
    CHECK_THROWS_AS(measure_retrieval(distances, {"a", "a", "a"}), InvalidInput);
  }
}
