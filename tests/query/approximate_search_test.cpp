#include "query/approximate_search.h"

#include <random>

#include <catch2/catch.hpp>

#include "tests/query/vector_tables.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

constexpr std::size_t dimension = 20;

VectorTable clustered_table(std::size_t size) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  std::vector<Model> models;
  std::vector<float> centre(dimension);
  for (std::size_t row = 0; row < size; ++row) {
    if (row % 15 == 0) {
      for (float& value : centre) value = normal(random);
    }
    Model model{static_cast<std::int64_t>(row), "/" + std::to_string(row), 1.0, centre};
    for (float& value : model.values) value += 0.2F * normal(random);
    models.push_back(std::move(model));
  }
  return table_of(models);
}

std::vector<std::pair<std::size_t, double>> rows_of(const SearchResult& result) {
  std::vector<std::pair<std::size_t, double>> rows;
  for (const Match& match : result.matches) rows.emplace_back(match.row, match.distance);
  return rows;
}

}  // namespace

TEST_CASE("an approximate search finds most of the nearest, and says which share") {
  const VectorTable table = clustered_table(3000);
  const ExactSearch exact(table, similarity_metric(8, 0.5));
  const ApproximateSearch search(exact);
  const Recall recall = search.measure_recall(exact, 10);
  CHECK(recall.count == 10);
  CHECK(recall.sampled == 100);
  CHECK(recall.share > 0.9);
  CHECK(recall.share <= 1.0);
  std::size_t found = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    const auto truth = rows_of(exact.search(table.values(i * 30), {.count = 10}));
    const auto approximate = rows_of(search.search(exact, table.values(i * 30), {.count = 10}));
    CHECK(std::ranges::is_sorted(approximate, {}, &std::pair<std::size_t, double>::second));
    for (const auto& match : approximate) found += std::ranges::count(truth, match);
  }
  CHECK(recall.share == Approx(static_cast<double>(found) / 1000));
}

TEST_CASE("an approximate search gives the same answer every time") {
  const ExactSearch exact(clustered_table(2000), similarity_metric(8, 1.0));
  const ApproximateSearch first(exact);
  std::srand(77);
  const ApproximateSearch second(exact);
  for (std::size_t row = 0; row < 2000; row += 10) {
    const std::span<const float> query = exact.collection().values(row);
    CHECK(rows_of(first.search(exact, query, {.count = 20})) ==
          rows_of(second.search(exact, query, {.count = 20})));
  }
}

TEST_CASE("small collections and ones without any difference are searched, too") {
  const std::size_t size = GENERATE(1U, 5U, 40U, 500U);
  std::vector<Model> models;
  for (std::size_t row = 0; row < size; ++row) {
    models.push_back({static_cast<std::int64_t>(row), std::to_string(row), 1.0,
                      std::vector<float>(dimension, 0.5F)});
  }
  const ExactSearch exact(table_of(models), similarity_metric(8, 1.0));
  const ApproximateSearch search(exact);
  const std::size_t count = std::min<std::size_t>(size, 10);
  CHECK(search.search(exact, models[0].values, {.count = 10}).matches.size() == count);
}
