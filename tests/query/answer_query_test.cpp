#include "query/answer_query.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "features/descriptor/chirality.h"
#include "features/descriptor/fused_signature.h"
#include "tests/support/ball_clouds.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

std::int64_t put_model(ShapeStore& store, const std::string& path, unsigned seed, bool has_fused) {
  ShapeRecord record;
  record.path = path;
  record.scale = 5.0;
  ShapeData data{.balls = random_balls(30, seed),
                 .signature = std::vector<float>(100, static_cast<float>(seed)),
                 .fused = {}};
  if (has_fused) data.fused = compute_fused_signature(data.balls);
  return store.put(record, data);
}

const QueryOptions fused_options{.count = 3, .signature = SignatureKind::mdbd_fused};

}  // namespace

TEST_CASE("a model without mdbd-fused in the database is found all the same, by its balls") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t old = put_model(*store, "/old.off", 1, false);
  put_model(*store, "/new.off", 2, true);
  put_model(*store, "/twin.off", 1, true);
  const QueryAnswer answer = query_by_id(*store, old, fused_options);
  CHECK(answer.completed == 1);
  REQUIRE(answer.result.matches.size() == 3);
  CHECK(answer.result.matches[0].path == "/old.off");
  CHECK(answer.result.matches[1].path == "/twin.off");
  CHECK(answer.result.matches[1].distance == 0.0);
  CHECK(answer.result.matches[2].distance > 0.1);
  store->put_vector(old, stored_mdbd_fused, compute_fused_signature(random_balls(30, 1)));
  CHECK(query_by_id(*store, old, fused_options).completed == 0);
}

TEST_CASE("mdbd-100 is what is compared unless something else is asked for") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = put_model(*store, "/a.off", 1, false);
  put_model(*store, "/b.off", 3, false);
  const QueryAnswer answer = query_by_id(*store, id, {.count = 2});
  CHECK(answer.completed == 0);
  CHECK(answer.result.matches.at(1).distance == Approx(4 * std::sqrt(50.0)));
}

TEST_CASE("the weight of the walk can be another than the recipe's, with a cache beside or not") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = put_model(*store, "/a.off", 1, false);
  put_model(*store, "/b.off", 3, false);
  QueryOptions options{.count = 2, .least_cached_models = 1};
  if (GENERATE(false, true)) options.cached_database = folder / "a.db";
  for (int repetition = 0; repetition < 2; ++repetition) {
    for (const double weight : {0.0, 0.35, 3.0}) {
      options.walk_weight = weight;
      CHECK(query_by_id(*store, id, options).result.matches.at(1).distance ==
            Approx(2 * std::sqrt(50.0) * (1.0 + weight)));
    }
    options.walk_weight.reset();
    CHECK(query_by_id(*store, id, options).result.matches.at(1).distance ==
          Approx(4 * std::sqrt(50.0)));
  }
}

TEST_CASE(
    "with a unit sizes are comparable, and those of models without one are taken to be in it") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const auto put = [&](const std::string& path, double scale, const std::string& statistics) {
    ShapeRecord record;
    record.path = path;
    record.scale = scale;
    record.statistics = statistics;
    return store->put(
        record,
        {.balls = random_balls(30, 1), .signature = std::vector<float>(100, 1.0F), .fused = {}});
  };
  const auto id = put("/part.step", 50.8, R"({"unit":"mm"})");
  put("/part.stl", 2.0, R"({"unit":"unknown"})");
  put("/declared.stl", 2.0, R"({"unit":"inch","unit_declared":true})");
  put("/other.stl", 50.8, R"({"unit":"unknown"})");
  const auto paths = [&](const std::string& unit) {
    std::vector<std::string> found;
    const QueryOptions options{.unit = unit, .has_same_size = true};
    for (const Match& match : query_by_id(*store, id, options).result.matches) {
      found.push_back(match.path);
    }
    std::ranges::sort(found);
    return found;
  };
  using Paths = std::vector<std::string>;
  CHECK(paths("") == Paths{"/other.stl", "/part.step"});
  CHECK(paths("inch") == Paths{"/declared.stl", "/part.step", "/part.stl"});
  CHECK(paths("mm") == Paths{"/declared.stl", "/other.stl", "/part.step"});
}

TEST_CASE("with chirality a mirrored twin comes after the one of the same hand") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const auto put = [&](const std::string& path, const Eigen::Matrix3d& turn) {
    ShapeRecord record;
    record.path = path;
    record.scale = 5.0;
    const std::vector<Ball> balls = moved_balls(random_balls(40, 1), turn, 3.0, {1, 2, 3});
    return store->put(record, {.balls = balls,
                               .signature = std::vector<float>(100, 1.0F),
                               .fused = compute_fused_signature(balls)});
  };
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1, -1, 1).asDiagonal();
  const std::int64_t id = put("/query.off", Eigen::Matrix3d::Identity());
  put("/a_mirrored.off", mirror * some_rotation());
  put("/b_turned.off", some_rotation());
  put_model(*store, "/other.off", 7, true);
  for (const SignatureKind signature : {SignatureKind::mdbd_100, SignatureKind::mdbd_fused}) {
    QueryOptions options{.count = 4, .signature = signature};
    const QueryAnswer without = query_by_id(*store, id, options);
    CHECK_FALSE(without.result.matches[0].hand);
    options.has_chirality = true;
    const QueryAnswer answer = query_by_id(*store, id, options);
    CHECK(answer.result.part_names.back() == "chirality");
    REQUIRE(answer.result.matches.size() == 4);
    const std::vector<Match>& matches = answer.result.matches;
    for (const std::size_t twin : {0U, 1U}) {  // in either order: they differ by rounding
      CHECK((matches[twin].path == "/query.off" || matches[twin].path == "/b_turned.off"));
      CHECK(matches[twin].hand == Hand::same);
      CHECK(matches[twin].distance < 1e-4);
    }
    CHECK(matches[2].path == "/a_mirrored.off");
    CHECK(matches[2].hand == Hand::mirrored);
    CHECK(matches[2].distance > 2 * least_chirality - 1e-4);
    CHECK(matches[2].parts.back() == Approx(matches[2].distance).margin(1e-4));
  }
}

TEST_CASE("hands are told from what was read, whatever is removed from the database meanwhile") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const std::int64_t id = put_model(*store, "/a.off", 1, true);
  const std::int64_t twin = put_model(*store, "/b.off", 1, true);
  ShapeSearch search(*store, {.count = 2, .has_chirality = true});
  store->remove(twin);
  const QueryAnswer answer = search.by_id(id);
  CHECK(answer.result.matches.at(1).path == "/b.off");
  CHECK(answer.result.matches.at(1).hand == Hand::same);
}

TEST_CASE("the numbers that differ the most are told in order, with what they say") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const auto put = [&](const std::string& path, std::vector<float> signature) {
    ShapeRecord record;
    record.path = path;
    record.scale = 5.0;
    return store->put(
        record, {.balls = random_balls(10, 1), .signature = std::move(signature), .fused = {}});
  };
  std::vector<float> values(100, 0.5F);
  const std::int64_t id = put("/a.off", values);
  values[2] = 0.75F;
  values[50] = 0.25F;
  values[99] = 1.5F;
  put("/b.off", values);
  const QueryAnswer answer = query_by_id(*store, id, {.differences = 2});
  CHECK(answer.result.matches.at(0).differences.empty());
  const std::vector<NumberDifference>& differences = answer.result.matches.at(1).differences;
  REQUIRE(differences.size() == 2);
  CHECK(differences[0].name == "walk sum 50");
  CHECK(differences[0].query == 0.5F);
  CHECK(differences[0].match == 1.5F);
  CHECK(differences[1].name == "radius 3");
}

TEST_CASE("filters apply before the best are taken, and the same size is that of the query") {
  const TemporaryDirectory folder;
  const auto store = open_store(folder / "a.db");
  const auto put = [&](const std::string& path, float number, double scale) {
    ShapeRecord record;
    record.path = path;
    record.scale = scale;
    return store->put(
        record,
        {.balls = random_balls(3, 1), .signature = std::vector<float>(100, number), .fused = {}});
  };
  const std::int64_t id = put("/bolt/a.off", 0.0F, 5.0);
  put("/bolt/b.stl", 1.0F, 5.04);
  put("/nut/c.stl", 2.0F, 4.0);
  put("/nut/d.stl", 3.0F, 4.96);
  const auto paths = [&](const QueryOptions& options) {
    std::string result;
    for (const Match& match : query_by_id(*store, id, options).result.matches) {
      result += match.path + ' ';
    }
    return result;
  };
  CHECK(paths({.count = 1, .filter = {.glob = "*.stl"}}) == "/bolt/b.stl ");
  CHECK(paths({.count = 2, .filter = {.label = "nut"}}) == "/nut/c.stl /nut/d.stl ");
  CHECK(paths({.count = 2, .filter = {.max_scale = 4.99}}) == "/nut/c.stl /nut/d.stl ");
  CHECK(paths({.has_same_size = true}) == "/bolt/a.off /bolt/b.stl /nut/d.stl ");
  CHECK(paths({.filter = {.glob = "*.stl"}, .has_same_size = true}) == "/bolt/b.stl /nut/d.stl ");
  CHECK(paths({.threshold = 2 * std::sqrt(50.0) + 1e-6}) == "/bolt/a.off /bolt/b.stl ");
}
