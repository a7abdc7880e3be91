#include "query/metric_sketch.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "query/sketch_list.h"
#include "query/sketch_tree.h"
#include "tests/query/vector_tables.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

constexpr std::size_t vector_size = 60;

// Numbers that vary together, far from the origin by `offset`.
std::vector<Model> correlated_collection(std::size_t size, float offset, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  std::vector<Model> collection(size);
  for (Model& vector : collection) {
    const float common = normal(random);
    for (std::size_t i = 0; i < vector_size; ++i) {
      const float sign = i % 3 == 0 ? -1.0F : 1.0F;
      vector.values.push_back(offset + sign * common + 0.1F * normal(random));
    }
  }
  return collection;
}

std::vector<MetricBlock> two_blocks(PointNorm norm) {
  return {{.first = 0, .count = 40, .weight = 1.0, .norm = norm},
          {.first = 40, .count = 20, .weight = 0.5, .norm = norm}};
}

double true_distance(std::span<const float> f, std::span<const float> g,
                     std::span<const MetricBlock> blocks) {
  double sum = 0.0;
  for (const MetricBlock& block : blocks) {
    double of_block = 0.0;
    for (std::size_t i = block.first; i < block.first + block.count; ++i) {
      const double difference = double{f[i]} - double{g[i]};
      of_block += block.norm == PointNorm::l1 ? std::abs(difference) : difference * difference;
    }
    sum += block.weight * (block.norm == PointNorm::l1 ? of_block : std::sqrt(of_block));
  }
  return sum;
}

double magnitude(std::span<const float> values) {
  double sum = 0.0;
  for (const float value : values) sum += std::abs(value);
  return sum;
}

double sketch_distance(std::span<const float> f, std::span<const float> g, PointNorm norm) {
  const MetricBlock whole{.first = 0, .count = f.size(), .norm = norm};
  return true_distance(f, g, std::span(&whole, 1));
}

}  // namespace

TEST_CASE("distances of sketches never exceed those of their vectors, and come near them") {
  const PointNorm norm = GENERATE(PointNorm::l1, PointNorm::l2);
  const float offset = GENERATE(0.0F, 1000.0F);
  const std::vector<MetricBlock> blocks = two_blocks(norm);
  const auto collection = correlated_collection(200, offset, 1);
  const MetricSketch sketch(table_of(collection), blocks, 6);
  REQUIRE(sketch.size() == 6);
  CHECK(sketch.norm() == norm);
  std::vector<float> f(sketch.size());
  std::vector<float> g(sketch.size());
  double of_sketches = 0.0;
  double of_vectors = 0.0;
  for (std::size_t i = 0; i < collection.size(); ++i) {
    sketch.write(collection[i].values, f);
    for (std::size_t j = 0; j < i; ++j) {
      sketch.write(collection[j].values, g);
      const double bound = sketch_distance(f, g, norm);
      const double distance = true_distance(collection[i].values, collection[j].values, blocks);
      const double margin =
          sketch.margin(std::max(magnitude(collection[i].values), magnitude(collection[j].values)));
      if (bound > distance + margin) FAIL_CHECK(bound << " > " << distance << " + " << margin);
      of_sketches += bound;
      of_vectors += distance;
    }
  }
  CHECK(of_sketches > 0.65 * of_vectors);
}

TEST_CASE("distances in single precision are within their margin") {
  const PointNorm norm = GENERATE(PointNorm::l1, PointNorm::l2);
  const auto collection = correlated_collection(100, 10.0F, 2);
  for (const Model& vector : collection) {
    const double distance = true_distance(collection[0].values, vector.values, two_blocks(norm));
    CHECK(block_distance(collection[0].values, vector.values, two_blocks(norm)) ==
          Approx(distance).epsilon(single_precision_margin(vector_size)));
  }
}

TEST_CASE("blocks that weigh nothing have no part in a sketch") {
  std::vector<MetricBlock> blocks = two_blocks(PointNorm::l2);
  blocks[1].weight = 0.0;
  auto collection = correlated_collection(50, 0.0F, 3);
  for (Model& vector : collection) vector.values.back() *= 1e6F;
  const MetricSketch sketch(table_of(collection), blocks, 100);
  CHECK(sketch.size() == 40);
  std::vector<float> numbers(40);
  std::vector<float> changed(40);
  std::vector<float> vector = collection[7].values;
  sketch.write(vector, numbers);
  vector.back() = 3.0F;
  sketch.write(vector, changed);
  CHECK(numbers == changed);
}

TEST_CASE("what is within a radius is visited, once, also where the radius shrinks") {
  const PointNorm norm = GENERATE(PointNorm::l1, PointNorm::l2);
  const std::size_t dimension = GENERATE(1U, 5U, 64U);
  const std::size_t count = GENERATE(1U, 100U, 10'000U);
  constexpr std::size_t rows = 2003;
  std::mt19937 random(4);
  std::uniform_real_distribution<float> anywhere;
  std::vector<float> points(rows * dimension);
  for (float& value : points) value = std::round(8 * anywhere(random)) / 8;  // many equal points
  const SketchList list(points, dimension, norm);
  std::size_t visited = 0;
  for (std::size_t query = 0; query < 20; ++query) {
    const std::span<const float> point = std::span(points).subspan(query * dimension, dimension);
    const double radius = 0.02 * static_cast<double>(dimension * query);
    std::vector<int> visits(rows, 0);
    std::vector<bool> is_announced(rows, false);
    list.visit_within(
        point, 1000.0, count,
        [&](std::size_t row) {
          ++visits[row];
          return radius;
        },
        [&](std::size_t row) { is_announced[row] = true; });
    for (std::size_t row = 0; row < rows; ++row) {
      const double distance =
          sketch_distance(point, std::span(points).subspan(row * dimension, dimension), norm);
      if (distance <= radius && visits[row] != 1) FAIL_CHECK(row << " at " << distance);
      CHECK_FALSE((is_announced[row] && visits[row] > 1));
      visited += visits[row] > 0 ? 1 : 0;
    }
  }
  CHECK(visited < 20 * rows);
}

TEST_CASE("a tree of bytes visits what is within a radius") {
  constexpr std::size_t dimension = 5;
  constexpr std::size_t rows = 2003;
  std::mt19937 random(4);
  std::uniform_real_distribution<float> anywhere;
  std::vector<float> points(rows * dimension);
  for (float& value : points) value = anywhere(random);
  const SketchList list(points, dimension, PointNorm::l2);
  const SketchTree tree(list.points(), dimension);
  std::vector<float> place(dimension);
  for (std::size_t query = 0; query < 20; ++query) {
    const std::span<const float> point = std::span(points).subspan(query * dimension, dimension);
    const double radius = 0.05 * static_cast<double>(query);
    std::vector<bool> is_visited(rows, false);
    list.quantiser().locate(point, place);
    tree.visit_within(place, list.reach(10.0), [&](std::size_t row) {
      is_visited[row] = true;
      return list.reach(radius);
    });
    for (std::size_t row = 0; row < rows; ++row) {
      const double distance = sketch_distance(
          point, std::span(points).subspan(row * dimension, dimension), PointNorm::l2);
      if (distance <= radius && !is_visited[row]) FAIL_CHECK(row << " at " << distance);
    }
    CHECK(std::ranges::count(is_visited, true) < static_cast<std::ptrdiff_t>(rows));
  }
}
