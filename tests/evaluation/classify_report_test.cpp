#include "evaluation/reports/classify_report.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/descriptor/similarity_distance.h"
#include "report/format_report.h"
#include "tests/evaluation/recording_progress.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Contains;

namespace {

/// Boxes and tori, which are easily told apart.
class Bench {
 public:
  explicit Bench(int per_class = 10) {
    for (int i = 0; i < per_class; ++i) {
      TriangleMesh box = test::make_cube();
      for (Eigen::Vector3d& vertex : box.vertices) vertex.x() *= 1.0 + 0.05 * i;
      write("box", i, box);
      write("torus", i, test::make_torus(1, 0.2 + 0.02 * i, 12, 8));
    }
    recipe.balls = 20;
    recipe.descriptor_balls = 10;
    recipe.walk_steps = 5;
  }

  void write(const std::string& label, int number, const TriangleMesh& mesh) {
    folder.write("models/" + label + "/" + std::to_string(number) + ".off", test::to_off(mesh));
  }

  EvaluationInput input(std::size_t jobs = 1) {
    collection = find_labelled_models(folder / "models", 0, 1);
    cache = std::make_unique<ModelCache>(
        CacheOptions{.folder = folder / "cache", .jobs = jobs, .limits = {}}, recipe, progress);
    return {collection, *cache, 1};
  }

  test::TemporaryDirectory folder;
  Recipe recipe;
  test::RecordingProgress progress;
  LabelledCollection collection;
  std::unique_ptr<ModelCache> cache;
};

ClassifyOptions few_runs() {
  ClassifyOptions options;
  options.runs = 3;
  return options;
}

/// The share of the models of some parts that a run's prediction is right for.
double share_right(const nlohmann::ordered_json& data, const nlohmann::ordered_json& method,
                   std::size_t run, const std::string& letters) {
  const std::string parts = data["runs"][run]["parts"];
  double right = 0;
  double all = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (letters.find(parts[i]) == std::string::npos) continue;
    ++all;
    right += method["predicted"][run][i] == data["models"][i]["label"] ? 1 : 0;
  }
  return right / all;
}

/// The class of the nearest model of the training part, from the report's numbers alone.
std::size_t nearest_label(const nlohmann::ordered_json& data, std::size_t run, std::size_t model) {
  const std::string parts = data["runs"][run]["parts"];
  const auto vector = [&](std::size_t i) {
    return data["models"][i]["mdbd-100"].get<std::vector<float>>();
  };
  double nearest = 1e300;
  std::size_t label = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == model || parts[i] != 'r') continue;
    const double distance =
        similarity_distance(vector(i), vector(model), data["similarity_distance"]["radii"],
                            data["similarity_distance"]["walk_weight"])
            .total;
    if (distance < nearest) {
      nearest = distance;
      label = data["models"][i]["label"];
    }
  }
  return label;
}

}  // namespace

TEST_CASE("the numbers of a classification can be computed again from its data") {
  Bench bench;
  const Report report = make_classify_report(bench.input(), few_runs());
  const auto& data = report.data;
  REQUIRE(data["methods"].size() == 5);
  REQUIRE(data["runs"].size() == 3);
  REQUIRE(data["models"].size() == 20);
  CHECK(data["classes"] == std::vector<std::string>{"box", "torus"});
  for (const auto& model : data["models"]) {
    CHECK(model["paper_features"].size() == 130);
    CHECK(model["mdbd-100"].size() == 15);
  }
  for (const auto& method : data["methods"]) {
    double sum = 0;
    for (std::size_t run = 0; run < 3; ++run) {
      CHECK(method["test_accuracy"][run] == share_right(data, method, run, "t"));
      CHECK(method["overall_accuracy"][run] == share_right(data, method, run, "rvt"));
      sum += method["test_accuracy"][run].get<double>();
    }
    CHECK(method["test"]["mean"].get<double>() == Approx(sum / 3));
  }
  for (std::size_t run = 0; run < 3; ++run) {
    for (std::size_t i = 0; i < 20; ++i) {
      CHECK(data["methods"][3]["predicted"][run][i] == nearest_label(data, run, i));
    }
  }
}

TEST_CASE("boxes and tori are told apart; the report shows it") {
  Bench bench;
  const Report report = make_classify_report(bench.input(), few_runs());
  for (const int learner : {0, 1, 2}) {
    CHECK(report.data["methods"][learner]["overall"]["mean"] > 0.9);
  }
  CHECK(report.data["methods"][4]["overall"]["mean"] == 0.5);
  CHECK(bench.progress.stages == std::vector<std::string>{"clean models: 20", "training: 6"});
  CHECK_THAT(report.notes.at(0), Contains("20 balls; the paper has 800"));
  const std::string text = format_report_text(report, 100);
  CHECK_THAT(text, Contains("Test part: 3 models in each of 3 runs"));
  CHECK_THAT(text, Contains("95.4"));
  CHECK_THAT(format_report_html(report), Contains("test part, sum of 3 runs"));
}

TEST_CASE("a classification depends on its seed, not on the number of jobs") {
  Bench bench;
  const auto data = make_classify_report(bench.input(), few_runs()).data;
  CHECK(make_classify_report(bench.input(3), few_runs()).data == data);
  EvaluationInput input = bench.input();
  input.seed = 2;
  CHECK(make_classify_report(input, few_runs()).data["runs"] != data["runs"]);
}

TEST_CASE("mdbd-100 has the balls of the standard recipe, the paper's features have all") {
  Bench bench(4);
  bench.recipe.balls = 510;
  bench.recipe.minimum_radius = 0.004;
  bench.recipe.radius_tolerance = 0.05;
  bench.recipe.walk_steps = 8;
  const auto data = make_classify_report(bench.input(), few_runs()).data;
  CHECK(data["paper_feature_balls"] == 510);
  CHECK(data["signature_balls"] == 500);
  bench.recipe.balls = 500;
  const CleanModels clean = describe_clean_models(bench.input());
  for (std::size_t i = 0; i < clean.models.size(); ++i) {
    CHECK(data["models"][i]["mdbd-100"] == clean.descriptions[i].descriptor);
  }
}

TEST_CASE("a class of one model is named") {
  Bench bench;
  bench.write("cube", 1, test::make_cube());
  const Report report = make_classify_report(bench.input(), few_runs());
  CHECK_THAT(report.notes.at(1), Contains("1 class of one model"));
}

TEST_CASE("what cannot be classified is said") {
  Bench bench(3);
  const auto make = [&](const ClassifyOptions& options) {
    return make_classify_report(bench.input(), options);
  };
  CHECK_THROWS_WITH(make(few_runs()), Contains("at least 7 models; there are 6"));
  CHECK_THROWS_WITH(make({.runs = 0, .network = {}}), Contains("at least one run"));
  bench.recipe.balls = 19;
  CHECK_THROWS_WITH(make(few_runs()), Contains("at least 20 balls a model; the recipe has 19"));
  bench.recipe.balls = 20;
  std::filesystem::remove_all(bench.folder / "models/torus");
  CHECK_THROWS_WITH(make(few_runs()), Contains("all are of the class box"));
}
