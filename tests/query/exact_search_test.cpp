#include "query/exact_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/descriptor/fused_signature.h"
#include "features/descriptor/similarity_distance.h"
#include "tests/query/vector_tables.h"

using mdbd::ExactSearch;
using mdbd::InvalidInput;
using mdbd::Match;
using mdbd::SearchMethod;
using mdbd::SearchOptions;
using mdbd::SearchResult;
using mdbd::similarity_distance;
using mdbd::similarity_metric;
using mdbd::SimilarityDistance;
using mdbd::test::Model;
using mdbd::test::table_of;

namespace {

constexpr int radius_count = 6;
constexpr std::size_t dimension = 10;

// Clusters of different tightness with exact duplicates, in an order that is not that of the paths.
std::vector<Model> make_collection(std::size_t size, std::mt19937& generator) {
  std::uniform_real_distribution<float> anywhere(0.0F, 1.0F);
  std::vector<Model> collection;
  for (std::size_t i = 0; i < size; ++i) {
    Model vector{.shape_id = static_cast<std::int64_t>(i + 1),
                 .path = "/models/" + std::to_string(generator()) + ".off",
                 .scale = 1.0 + static_cast<double>(i),
                 .values = std::vector<float>(dimension)};
    const bool is_near_another = i > 0 && anywhere(generator) < 0.8F;
    if (is_near_another) vector.values = collection[generator() % i].values;
    const float spread = is_near_another ? std::array{0.0F, 1e-6F, 1e-2F}[generator() % 3] : 1.0F;
    for (float& value : vector.values) value += spread * anywhere(generator);
    collection.push_back(std::move(vector));
  }
  return collection;
}

std::vector<Match> brute_force(const std::vector<Model>& collection, std::span<const float> query,
                               const SearchOptions& options, double walk_weight) {
  std::vector<Match> matches;
  for (const Model& vector : collection) {
    const SimilarityDistance distance =
        similarity_distance(query, vector.values, radius_count, walk_weight);
    if (distance.total > options.threshold || vector.scale < options.min_scale ||
        vector.scale > options.max_scale) {
      continue;
    }
    matches.push_back({.id = vector.shape_id,
                       .path = vector.path,
                       .scale = vector.scale,
                       .distance = distance.total,
                       .parts = {distance.radii, distance.walk},
                       .differences = {},
                       .hand = {}});
  }
  std::ranges::sort(matches, [](const Match& a, const Match& b) {
    return std::pair(a.distance, a.path) < std::pair(b.distance, b.path);
  });
  matches.resize(std::min(options.count, matches.size()));
  return matches;
}

void check_equal(const SearchResult& result, const std::vector<Match>& expected) {
  REQUIRE(result.matches.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Match& match = result.matches[i];
    CHECK(match.id == expected[i].id);
    CHECK(match.path == expected[i].path);
    CHECK(match.scale == expected[i].scale);
    CHECK(match.distance == expected[i].distance);
    CHECK(match.parts == expected[i].parts);
  }
}

std::vector<Model> models(const std::vector<std::pair<std::string, std::vector<float>>>& of) {
  std::vector<Model> collection;
  for (const auto& [path, values] : of) {
    collection.push_back({static_cast<std::int64_t>(collection.size()) + 1, path, 1.0, values});
  }
  return collection;
}

mdbd::VectorTable table_with(const std::vector<std::pair<std::string, std::vector<float>>>& of) {
  return table_of(models(of));
}

}  // namespace

TEST_CASE("the answer is that of a brute-force search, ties included, scanned or indexed") {
  const double walk_weight = GENERATE(0.0, 0.5, 1.0, 3.0, 1.0 / 3.0);
  const std::size_t size = GENERATE(0U, 1U, 2U, 500U);
  const SearchMethod method = GENERATE(SearchMethod::scan, SearchMethod::list, SearchMethod::tree);
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 generator(seed);
    const std::vector<Model> collection = make_collection(size, generator);
    const std::vector<Model> outside = make_collection(1, generator);
    const ExactSearch search(table_of(collection), similarity_metric(radius_count, walk_weight), 1,
                             method);
    const bool is_member = seed % 2 == 1 && size > 0;
    const std::vector<float>& query =
        is_member ? collection[generator() % size].values : outside[0].values;
    for (const std::size_t k :
         {std::size_t{1}, std::size_t{5}, std::max<std::size_t>(size, 1), size + 10}) {
      INFO("alpha " << walk_weight << ", size " << size << ", seed " << seed << ", k " << k);
      const SearchResult result = search.search(query, {.count = k});
      check_equal(result, brute_force(collection, query, {.count = k}, walk_weight));
      CHECK(result.compared == size);
      CHECK(result.examined >= result.matches.size());
      CHECK(result.examined <= size);
    }
  }
}

TEST_CASE("thresholds and ranges of scale apply before the best are taken") {
  const SearchMethod method = GENERATE(SearchMethod::scan, SearchMethod::list, SearchMethod::tree);
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 generator(seed);
    const std::vector<Model> collection = make_collection(400, generator);
    const ExactSearch search(table_of(collection), similarity_metric(radius_count, 1.0), 1, method);
    const std::vector<float>& query = collection[generator() % 400].values;
    CHECK(search.search(query, {.count = 1, .min_scale = 50.0, .max_scale = 60.0}).compared == 11);
    CHECK(search.search(query, {.count = 1, .min_scale = 60.0, .max_scale = 50.0}).compared == 0);
    const double some_distance = search.search(query, {.count = 30}).matches.back().distance;
    for (const SearchOptions& options :
         {SearchOptions{.count = 7, .min_scale = 390.0},
          SearchOptions{.count = 500, .threshold = some_distance},
          SearchOptions{.count = 5, .threshold = 0.0},
          SearchOptions{.count = 20, .threshold = 1.0, .min_scale = 50.0, .max_scale = 60.0},
          SearchOptions{.count = 3, .min_scale = 401.0}}) {
      INFO("seed " << seed << ", count " << options.count << ", from " << options.min_scale);
      check_equal(search.search(query, options), brute_force(collection, query, options, 1.0));
    }
  }
}

TEST_CASE("collections without any difference, or along one line, are searched like all others") {
  const SearchMethod method = GENERATE(SearchMethod::scan, SearchMethod::list, SearchMethod::tree);
  const bool is_line = GENERATE(false, true);
  std::mt19937 generator(5);
  std::vector<Model> collection = make_collection(300, generator);
  for (std::size_t i = 0; i < collection.size(); ++i) {
    collection[i].values.assign(dimension, is_line ? 0.01F * static_cast<float>(i % 60) : 0.25F);
  }
  const ExactSearch search(table_of(collection), similarity_metric(radius_count, 1.0), 1, method);
  for (const std::size_t k : {1U, 7U, 300U}) {
    const std::vector<float>& query = collection[42].values;
    check_equal(search.search(query, {.count = k}),
                brute_force(collection, query, {.count = k}, 1.0));
  }
}

TEST_CASE("bounds spare most of a collection") {
  const SearchMethod method = GENERATE(SearchMethod::scan, SearchMethod::list, SearchMethod::tree);
  std::mt19937 generator(7);
  const std::vector<Model> collection = make_collection(500, generator);
  const SearchResult result =
      ExactSearch(table_of(collection), similarity_metric(radius_count, 1.0), 1, method)
          .search(collection[0].values, {.count = 1});
  CHECK(result.examined < 100);
}

TEST_CASE("an index is built only where it pays") {
  std::mt19937 generator(9);
  std::vector<Model> collection = make_collection(12'000, generator);
  const auto has_index = [&](std::size_t searches) {
    return ExactSearch(table_of(collection), similarity_metric(radius_count, 1.0), searches)
        .has_index();
  };
  CHECK_FALSE(has_index(1));
  CHECK(has_index(12'000));
  collection.resize(100);
  CHECK_FALSE(has_index(12'000));
}

TEST_CASE("the order is that of the similarity distance where L2 has another one") {
  // L2: corner 1.13, axis 1.2. Similarity distance: corner 1.6, axis 1.2.
  const ExactSearch search(table_with({{"corner", {0.8F, 0.8F}}, {"axis", {1.2F, 0.0F}}}),
                           similarity_metric(1, 1.0));
  const SearchResult result = search.search(std::vector{0.0F, 0.0F}, {.count = 1});
  REQUIRE(result.matches.size() == 1);
  CHECK(result.matches[0].path == "axis");
}

TEST_CASE("equal distances are ordered by path, also where only one is asked for") {
  const ExactSearch search(table_with({{"c", {1.0F}}, {"a", {-1.0F}}, {"b", {1.0F}}}),
                           similarity_metric(1, 1.0));
  CHECK(search.search(std::vector{0.0F}, {.count = 1}).matches.at(0).path == "a");
  CHECK(search.search(std::vector{0.0F}, {.count = 2}).matches.at(1).path == "b");
}

TEST_CASE("a walk weight that rounds the weighted vectors does not lose a near model") {
  // The walk parts are large beside their differences, so that weighting by 1/3 rounds them.
  std::mt19937 generator(3);
  std::vector<Model> collection = make_collection(200, generator);
  for (Model& vector : collection) {
    vector.values.assign(dimension, 0.0F);
    vector.values[dimension - 1] = 1000.0F + static_cast<float>(generator() % 64) * 6.1e-5F;
  }
  const ExactSearch search(table_of(collection), similarity_metric(radius_count, 1.0 / 3.0), 1,
                           GENERATE(SearchMethod::scan, SearchMethod::list, SearchMethod::tree));
  for (const Model& query : collection) {
    check_equal(search.search(query.values, {.count = 5}),
                brute_force(collection, query.values, {.count = 5}, 1.0 / 3.0));
  }
}

TEST_CASE("a model is found although single precision takes it for farther than the next one") {
  // In each of the eight lanes 1 and then squares of little more than half its last digit, each of
  // which rounds up to the whole digit.
  constexpr std::size_t size = 100'000;
  constexpr float least = 2.466e-4F;
  std::vector<float> near(size, least);
  std::fill_n(near.begin(), 8, 1.0F);
  std::vector<float> far(size, 0.0F);
  far[0] = static_cast<float>(std::sqrt(8 + (size - 8.0) * least * least) * 1.0001);
  const ExactSearch search(table_with({{"far", far}, {"near", near}}), similarity_metric(size, 1.0),
                           1, SearchMethod::scan);
  const SearchResult result = search.search(std::vector<float>(size, 0.0F), {.count = 1});
  CHECK(result.matches.at(0).path == "near");
}

TEST_CASE("a weight that takes numbers beyond single precision is refused") {
  const std::vector<Model> large = models({{"a", {1.0F, 1e12F}}});
  CHECK_THROWS_AS(ExactSearch(table_of(large), similarity_metric(1, 1e5)), InvalidInput);
  CHECK_NOTHROW(ExactSearch(table_of(large), similarity_metric(1, 1.0)));
  const ExactSearch search(table_with({{"a", {1.0F, 1.0F}}}), similarity_metric(1, 1e5));
  CHECK_THROWS_AS(search.search(large[0].values), InvalidInput);
}

TEST_CASE("what does not fit is refused") {
  CHECK_THROWS_AS(
      ExactSearch(table_with({{"a", {1.0F, 2.0F}}, {"b", {1.0F}}}), similarity_metric(1, 1.0)),
      InvalidInput);
  CHECK_THROWS_AS(ExactSearch(table_with({{"a", {1.0F}}}), similarity_metric(2, 1.0)),
                  InvalidInput);
  const ExactSearch search(table_with({{"a", {1.0F, 2.0F}}}), similarity_metric(1, 1.0));
  CHECK_THROWS_AS(search.search(std::vector{1.0F}), InvalidInput);
  const float bad = GENERATE(std::numeric_limits<float>::quiet_NaN(),
                             std::numeric_limits<float>::infinity(), -1e30F);
  CHECK_THROWS_AS(search.search(std::vector{1.0F, bad}), InvalidInput);
  CHECK_THROWS_AS(ExactSearch(table_with({{"a", {1.0F, bad}}}), similarity_metric(1, 1.0)),
                  InvalidInput);
  CHECK_THROWS_AS(search.search(std::vector{1.0F, 2.0F}, {.count = 0}), InvalidInput);
}

TEST_CASE("mdbd-fused is ordered by the sum of its parts' L1 distances") {
  std::mt19937 generator(11);
  std::uniform_real_distribution<float> anywhere(0.0F, 0.05F);
  std::vector<Model> collection = make_collection(300, generator);
  for (Model& vector : collection) {
    vector.values.resize(mdbd::fused_size);
    for (float& value : vector.values) value = anywhere(generator);
  }
  collection[7].values = collection[3].values;
  const ExactSearch search(table_of(collection), mdbd::fused_metric(), 1,
                           GENERATE(SearchMethod::scan, SearchMethod::list, SearchMethod::tree));
  for (std::size_t query = 0; query < 20; ++query) {
    const SearchResult result = search.search(collection[query].values, {.count = 10});
    std::vector<std::pair<double, std::string>> expected;
    for (const Model& vector : collection) {
      const auto parts = mdbd::fused_part_distances(collection[query].values, vector.values);
      expected.emplace_back(std::accumulate(parts.begin(), parts.end(), 0.0), vector.path);
    }
    std::ranges::sort(expected);
    CHECK(result.examined < 100);
    REQUIRE(result.part_names.size() == mdbd::fused_parts.size());
    for (std::size_t i = 0; i < 10; ++i) {
      const Match& match = result.matches.at(i);
      CHECK(match.distance == expected[i].first);
      CHECK(match.path == expected[i].second);
      CHECK(std::accumulate(match.parts.begin(), match.parts.end(), 0.0) == Approx(match.distance));
    }
  }
}

TEST_CASE("with chirality the answer is that of a brute-force search, by either metric") {
  const auto make_metric = [](bool is_fused) {
    return mdbd::chiral_metric(is_fused ? mdbd::fused_metric()
                                        : similarity_metric(radius_count, 1.0));
  };
  const bool is_fused = GENERATE(false, true);
  std::mt19937 generator(3);
  std::uniform_real_distribution<float> anywhere(-0.05F, 0.05F);
  std::vector<Model> collection = make_collection(300, generator);
  for (Model& vector : collection) {
    vector.values.resize(mdbd::chirality_size + (is_fused ? mdbd::fused_size : 100));
    for (float& value : vector.values) value = anywhere(generator);
  }
  const auto metric = make_metric(is_fused);
  const ExactSearch search(table_of(collection), make_metric(is_fused), 1,
                           GENERATE(SearchMethod::scan, SearchMethod::list, SearchMethod::tree));
  for (std::size_t query = 0; query < 10; ++query) {
    const SearchResult result = search.search(collection[query].values, {.count = 10});
    std::vector<std::pair<double, std::string>> expected;
    for (const Model& vector : collection) {
      expected.emplace_back(metric->distance(collection[query].values, vector.values), vector.path);
    }
    std::ranges::sort(expected);
    for (std::size_t i = 0; i < 10; ++i) {
      const Match& match = result.matches.at(i);
      CHECK(match.distance == expected[i].first);
      CHECK(match.path == expected[i].second);
      CHECK(std::accumulate(match.parts.begin(), match.parts.end(), 0.0) == Approx(match.distance));
    }
  }
}
