#include "evaluation/reports/retrieval_report.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "evaluation/measures/vector_distance.h"
#include "evaluation/reports/retrieval_methods.h"
#include "features/core/errors.h"
#include "report/format_report.h"
#include "tests/evaluation/recording_progress.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Contains;

namespace {

std::string box(double x, double y) {
  TriangleMesh mesh = test::make_cube();
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex = {x * vertex.x(), y * vertex.y(), vertex.z()};
  return test::to_off(mesh);
}

/// Boxes, tori, and a class of one rod.
class Bench {
 public:
  Bench() {
    for (const double length : {1.0, 1.05, 1.1}) {
      folder.write("models/box/" + std::to_string(length) + ".off", box(length, 1));
    }
    for (const double minor : {0.3, 0.32}) {
      folder.write("models/torus/" + std::to_string(minor) + ".off",
                   test::to_off(test::make_torus(1, minor, 12, 8)));
    }
    folder.write("models/rod/1.off", box(8, 1));
    recipe.balls = 12;
    recipe.descriptor_balls = 5;
    recipe.walk_steps = 3;
    recipe.walk_weight = 0.5;
  }

  EvaluationInput input() {
    collection = find_labelled_models(folder / "models", 0, 1);
    cache = std::make_unique<ModelCache>(
        CacheOptions{.folder = folder / "cache", .jobs = 2, .limits = {}}, recipe, progress);
    return {collection, *cache, 1};
  }

  test::TemporaryDirectory folder;
  Recipe recipe;
  test::RecordingProgress progress;
  LabelledCollection collection;
  std::unique_ptr<ModelCache> cache;
};

}  // namespace

TEST_CASE("distances are sums of norms") {
  const std::vector<float> a = {1, 2, 3, 0};
  const std::vector<float> b = {1, 4, 0, 0};
  const auto distance = [&](const DistanceTerm& term) {
    return vector_distance(a, b, std::span(&term, 1));
  };
  CHECK(distance({.norm = VectorNorm::l1, .count = 4}) == 5.0);
  CHECK(distance({.norm = VectorNorm::l2, .count = 4}) == Approx(std::sqrt(13)));
  CHECK(distance({.norm = VectorNorm::chi_square, .count = 4}) == Approx(4.0 / 6 + 9.0 / 3));
  CHECK(distance({.norm = VectorNorm::l1, .first = 2, .count = 2, .weight = 0.5}) == 1.5);
}

TEST_CASE("mdbd-100 is compared by the similarity distance") {
  Bench bench;
  const EvaluationInput input = bench.input();
  const RetrievalComparison comparison = compare_retrieval(input, false);
  REQUIRE(comparison.methods.size() == 4);
  const DistanceMatrix expected = signature_matrix(input, describe_clean_models(input));
  REQUIRE(expected.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      CHECK(comparison.methods[0].distances(i, j) == expected(i, j));
      CHECK(comparison.methods[0].distances(i, j) ==
            Approx(comparison.methods[1].distances(i, j) +
                   0.5 * comparison.methods[2].distances(i, j)));
    }
  }
  CHECK(bench.progress.stages == std::vector<std::string>{"clean models: 6"});
}

TEST_CASE("a retrieval report shows every method on the same models") {
  Bench bench;
  const Report report = make_retrieval_report(bench.input(), {});
  const auto& data = report.data;
  CHECK(data["queries"] == 5);
  CHECK(data["left_out_queries"] == 1);
  CHECK(data["models"].size() == 6);
  std::vector<std::string> names;
  for (const auto& method : data["methods"]) {
    names.push_back(method["name"]);
    CHECK(method["classes"].size() == 2);
    CHECK(method["mean"]["precision"].size() == recall_levels);
    for (const auto& model : data["models"]) {
      const auto& term = method["distance"].back();
      CHECK(model["vectors"][method["vectors"].get<std::string>()].size() >=
            term["first"].get<std::size_t>() + term["count"].get<std::size_t>());
    }
  }
  CHECK(names == std::vector<std::string>{"mdbd-100", "radii alone", "walk alone", "mdbd-fused",
                                          "ESF", "GASD", "D2", "SH of distances"});
  CHECK(report.sections.size() == 5);
  CHECK_THAT(report.notes.at(0), Contains("1 model without another of the same class"));
  CHECK_THAT(report.summary, Contains("of 5 queries in 2 classes (radii alone"));
  CHECK_THAT(format_report_text(report, 80), Contains("mdbd-100"));

  // All of it is in the cache now.
  bench.progress.stages.clear();
  CHECK(make_retrieval_report(bench.input(), {}).data == data);
  CHECK(bench.progress.stages.empty());
}

TEST_CASE("the report is about the signature that is asked for") {
  Bench bench;
  EvaluationInput input = bench.input();
  input.signature = SignatureKind::mdbd_fused;
  const Report report = make_retrieval_report(input, {.has_rivals = false});
  CHECK(report.data["signature"] == "mdbd-fused");
  CHECK_THAT(report.summary, Contains("The first answer of mdbd-fused is of") &&
                                 Contains("(mdbd-100 ") && !Contains(", mdbd-fused"));
  const RetrievalComparison comparison = compare_retrieval(input, false);
  CHECK(comparison.methods[comparison.measured].name == "mdbd-fused");
  const DistanceMatrix expected = signature_matrix(input, describe_clean_models(input));
  CHECK(comparison.methods[comparison.measured].distances(0, 4) == expected(0, 4));
}

TEST_CASE("a wrong first answer is listed with the right one") {
  Bench bench;
  // By its shape a torus, by its class a rod: its nearest model is a torus.
  bench.folder.write("models/rod/2.off", test::to_off(test::make_torus(1, 0.31, 12, 8)));
  const Report report = make_retrieval_report(bench.input(), {.has_rivals = false});
  const auto& confusions = report.data["confusions"];
  const auto found = std::ranges::find_if(
      confusions, [](const auto& confusion) { return confusion["query"] == "rod/2.off"; });
  REQUIRE(found != confusions.end());
  CHECK_THAT((*found)["first_answer"].get<std::string>(), Contains("torus/0.3"));
  CHECK((*found)["first_of_class"] == "rod/1.off");
  CHECK((*found)["first_of_class_rank"].get<int>() > 1);
  CHECK((*found)["first_of_class_distance"] > (*found)["first_answer_distance"]);
}

TEST_CASE("without two models of a class there is nothing to report") {
  test::TemporaryDirectory folder;
  folder.write("models/a/1.off", box(1, 1));
  folder.write("models/b/1.off", box(2, 1));
  const LabelledCollection collection = find_labelled_models(folder / "models", 0, 1);
  test::RecordingProgress progress;
  Recipe recipe;
  recipe.balls = 5;
  ModelCache cache({.folder = folder / "cache", .jobs = 1, .limits = {}}, recipe, progress);
  CHECK_THROWS_AS(make_retrieval_report({collection, cache, 1}, {.has_rivals = false}),
                  InvalidInput);
}

TEST_CASE("measures of a single class are said to mean nothing") {
  test::TemporaryDirectory folder;
  folder.write("models/a/1.off", box(1, 1));
  folder.write("models/a/2.off", box(2, 1));
  const LabelledCollection collection = find_labelled_models(folder / "models", 0, 1);
  test::RecordingProgress progress;
  Recipe recipe;
  recipe.balls = 5;
  ModelCache cache({.folder = folder / "cache", .jobs = 1, .limits = {}}, recipe, progress);
  const Report report = make_retrieval_report({collection, cache, 1}, {.has_rivals = false});
  REQUIRE(report.notes.size() == 1);
  CHECK_THAT(report.notes[0], Contains("one class only"));
}
