// The promise of the exact search, whatever the vectors are: the answer is that of a brute-force
// search in double precision, models at the same distance ordered by path.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "features/descriptor/fused_signature.h"
#include "query/exact_search.h"
#include "tests/query/vector_tables.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

constexpr std::size_t rows = 300;
constexpr int radius_count = 6;

enum class Shape { uniform, clustered, equal, few_values, line, outlier, far_off };

constexpr std::array shapes = {Shape::uniform, Shape::clustered, Shape::equal,  Shape::few_values,
                               Shape::line,    Shape::outlier,   Shape::far_off};

float make_value(Shape shape, std::size_t row, std::size_t index, std::mt19937& random) {
  std::uniform_real_distribution<float> anywhere(0.0F, 1.0F);
  switch (shape) {
    case Shape::uniform:
      return anywhere(random);
    case Shape::clustered:
      return std::sin(static_cast<float>(row / 10 * 7 + index)) + 1e-3F * anywhere(random);
    case Shape::equal:
      return 0.25F;
    case Shape::few_values:
      return std::round(2.0F * anywhere(random));
    case Shape::line:
      return 0.01F * static_cast<float>(row % 60) * static_cast<float>(index + 1);
    case Shape::outlier:
      return row == 5 ? 1e6F * anywhere(random) : anywhere(random);
    case Shape::far_off:
      return 1000.0F + 1e-3F * anywhere(random);
  }
  return 0.0F;
}

std::vector<Model> make_collection(Shape shape, std::size_t dimension, float scale,
                                   std::mt19937& random) {
  std::vector<Model> collection;
  for (std::size_t row = 0; row < rows; ++row) {
    Model model{.shape_id = static_cast<std::int64_t>(row + 1),
                .path = std::to_string(random()),
                .scale = 1.0 + static_cast<double>(row),
                .values = {}};
    for (std::size_t i = 0; i < dimension; ++i) {
      model.values.push_back(scale * make_value(shape, row, i, random));
    }
    if (row % 11 == 10) model.values = collection[random() % row].values;
    collection.push_back(std::move(model));
  }
  return collection;
}

struct Expected {
  double distance;
  std::string path;
};

std::vector<Expected> brute_force(const std::vector<Model>& collection,
                                  const SignatureMetric& metric, std::span<const float> query,
                                  const SearchOptions& options) {
  std::vector<Expected> all;
  for (const Model& model : collection) {
    const double distance = metric.distance(query, model.values);
    if (distance > options.threshold || model.scale < options.min_scale ||
        model.scale > options.max_scale) {
      continue;
    }
    all.push_back({distance, model.path});
  }
  std::ranges::sort(all, {}, [](const Expected& e) { return std::pair(e.distance, e.path); });
  all.resize(std::min(options.count, all.size()));
  return all;
}

void check_answer(const ExactSearch& search, const std::vector<Model>& collection,
                  const SignatureMetric& metric, std::span<const float> query,
                  const SearchOptions& options) {
  const std::vector<Expected> expected = brute_force(collection, metric, query, options);
  const SearchResult result = search.search(query, options);
  REQUIRE(result.matches.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (result.matches[i].distance != expected[i].distance ||
        result.matches[i].path != expected[i].path) {
      FAIL_CHECK(i << ": " << result.matches[i].path << " at " << result.matches[i].distance
                   << " instead of " << expected[i].path << " at " << expected[i].distance);
    }
  }
}

using MetricMaker = std::unique_ptr<const SignatureMetric> (*)();

struct Signature {
  std::size_t dimension;
  MetricMaker make_metric;
};

const std::array signatures = {Signature{10, [] { return similarity_metric(radius_count, 1.0); }},
                               Signature{10, [] { return similarity_metric(radius_count, 0.0); }},
                               Signature{40, [] { return similarity_metric(radius_count, 7.3); }},
                               Signature{fused_size, [] { return fused_metric(); }}};

}  // namespace

TEST_CASE("no search loses a model: any vectors, metric, count, threshold and range of scale") {
  const Signature signature = signatures.at(GENERATE(range(0U, 4U)));
  const SearchMethod method = GENERATE(SearchMethod::scan, SearchMethod::list, SearchMethod::tree);
  const float scale = GENERATE(1.0F, 1e-30F, 1e6F);
  const auto metric = signature.make_metric();
  for (const Shape shape : shapes) {
    std::mt19937 random(static_cast<unsigned>(shape) + 1);
    const auto collection = make_collection(shape, signature.dimension, scale, random);
    const auto others = make_collection(Shape::uniform, signature.dimension, scale, random);
    const ExactSearch search(table_of(collection), signature.make_metric(), 1, method);
    for (const std::vector<float>* query :
         {&collection[0].values, &collection[random() % rows].values, &others[0].values}) {
      const double some_distance = metric->distance(*query, collection[7].values);
      for (const SearchOptions& options :
           {SearchOptions{.count = 1}, SearchOptions{.count = 10}, SearchOptions{.count = 100},
            SearchOptions{.count = rows + 1},
            SearchOptions{.count = rows, .threshold = some_distance},
            SearchOptions{.count = 4, .threshold = 0.0},
            SearchOptions{.count = 4, .threshold = -1.0},
            SearchOptions{.count = 5, .min_scale = 100.0, .max_scale = 120.0},
            SearchOptions{.count = 5, .threshold = some_distance, .max_scale = 12.0}}) {
        INFO("shape " << static_cast<int>(shape) << ", count " << options.count << ", threshold "
                      << options.threshold);
        check_answer(search, collection, *metric, *query, options);
      }
    }
  }
}
