#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include <catch2/catch.hpp>

#include "evaluation/reports/invariance_report.h"
#include "evaluation/reports/noise_report.h"
#include "evaluation/reports/representations_report.h"
#include "evaluation/reports/varied_models.h"
#include "features/core/errors.h"
#include "features/descriptor/fused_signature.h"
#include "perturbation/subdivision.h"
#include "report/format_report.h"
#include "tests/evaluation/recording_progress.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Contains;
using nlohmann::ordered_json;

namespace {

std::string box(double x, double y) {
  TriangleMesh mesh = test::make_cube();
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex = {x * vertex.x(), y * vertex.y(), vertex.z()};
  }
  return test::to_off(subdivide(subdivide(mesh)));
}

/// Boxes, tori, a class of one rod, and a file that is no model.
class Bench {
 public:
  Bench() {
    for (const double length : {1.3, 1.7, 2.2}) {
      folder.write("models/box/" + std::to_string(length) + ".off", box(length, 1.1));
    }
    for (const double minor : {0.3, 0.35}) {
      folder.write("models/torus/" + std::to_string(minor) + ".off",
                   test::to_off(test::make_torus(1, minor, 12, 8)));
    }
    folder.write("models/rod/1.off", box(8, 1));
    folder.write("models/rod/damaged.off", "OFF\n");
    recipe.balls = 10;
    recipe.radius_tolerance = 0.01;
    recipe.descriptor_balls = 5;
    recipe.walk_steps = 3;
    recipe.walk_weight = 0.5;
  }

  EvaluationInput input(std::uint64_t seed = 1) {
    collection = find_labelled_models(folder / "models", 0, 1);
    cache = std::make_unique<ModelCache>(
        CacheOptions{.folder = folder / "cache", .jobs = 2, .limits = {}}, recipe, progress);
    return {collection, *cache, seed};
  }

  test::TemporaryDirectory folder;
  Recipe recipe;
  test::RecordingProgress progress;
  LabelledCollection collection;
  std::unique_ptr<ModelCache> cache;
};

double norm(const ordered_json& f, const ordered_json& g, std::size_t begin, std::size_t end) {
  double sum = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    sum += std::pow(f[i].get<double>() - g[i].get<double>(), 2);
  }
  return std::sqrt(sum);
}

/// The rates of a change, computed from nothing but the descriptors in a report's data.
void check_measures(const ordered_json& data, const ordered_json& change) {
  const std::size_t k = data["radius_count"];
  const auto distance = [&](const ordered_json& f, const ordered_json& g) {
    return norm(f, g, 0, k) + data["walk_weight"].get<double>() * norm(f, g, k, f.size());
  };
  int first = 0;
  int found = 0;
  int asked = 0;
  for (const ordered_json& model : change["models"]) {
    const ordered_json& descriptor = model["descriptor"];
    double self = 0.0;
    std::string label;
    double nearest = HUGE_VAL;
    std::string nearest_label;
    int same_class = 0;
    for (const ordered_json& clean : data["models"]) {
      if (clean["name"] == model["name"]) {
        self = distance(descriptor, clean["descriptor"]);
        label = clean["class"];
      } else if (distance(descriptor, clean["descriptor"]) < nearest) {
        nearest = distance(descriptor, clean["descriptor"]);
        nearest_label = clean["class"];
      }
    }
    for (const ordered_json& clean : data["models"]) same_class += clean["class"] == label;
    CHECK(model["displacement"] == Approx(self).margin(1e-12));
    first += self <= nearest;
    asked += same_class > 1;
    found += same_class > 1 && nearest_label == label;
  }
  const auto count = static_cast<double>(change["models"].size());
  CHECK(change["measures"]["models"] == change["models"].size());
  CHECK(change["measures"]["self_first"] == Approx(first / count));
  CHECK(change["measures"]["class_accuracy"] == Approx(static_cast<double>(found) / asked));
}

bool has_note(const Report& report, const std::string& text) {
  return std::ranges::any_of(
      report.notes, [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

template <typename BlockType>
std::vector<BlockType> blocks_of(const Report& report) {
  std::vector<BlockType> found;
  for (const Section& section : report.sections) {
    for (const Block& block : section.blocks) {
      if (const auto* one = std::get_if<BlockType>(&block)) found.push_back(*one);
    }
  }
  return found;
}

}  // namespace

TEST_CASE("the noise report can be computed again from its data") {
  Bench bench;
  const Report report = make_noise_report(bench.input(), {.levels = {0.5, 3}, .queries = {}});
  CHECK(report.title == "Noise on models");
  CHECK_THAT(report.summary,
             Contains("By mdbd-100, of 6 models ") && Contains("with noise 0.5 %, "));
  const ordered_json& data = report.data;
  REQUIRE(data["models"].size() == 6);
  REQUIRE(data["noise"].size() == 2);
  CHECK(data["noise"][1]["level"] == 3);
  for (const ordered_json& level : data["noise"]) {
    CHECK(level["models"].size() == 6);
    CHECK(level["mean_shift"].size() == 8);
    check_measures(data, level);
  }
  const auto shift = [&](int level) {
    double sum = 0.0;
    for (const double one : data["noise"][level]["mean_absolute_shift"]) sum += one;
    return sum;
  };
  CHECK(shift(0) > 0);
  CHECK(shift(1) > shift(0));
  CHECK(has_note(report, "1 model(s) without another of their class"));
}

TEST_CASE("the noise report measures mdbd-fused when it is asked to") {
  Bench bench;
  EvaluationInput input = bench.input();
  input.signature = SignatureKind::mdbd_fused;
  const Report report = make_noise_report(input, {.levels = {1}, .queries = {}});
  const ordered_json& data = report.data;
  CHECK(data["signature"] == "mdbd-fused");
  REQUIRE(data["noise"][0]["models"].size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto clean = data["models"][i]["descriptor"].get<std::vector<float>>();
    const auto noisy = data["noise"][0]["models"][i]["descriptor"].get<std::vector<float>>();
    REQUIRE(clean.size() == fused_size);
    const auto parts = fused_part_distances(clean, noisy);
    CHECK(data["noise"][0]["models"][i]["displacement"].get<double>() ==
          Approx(std::accumulate(parts.begin(), parts.end(), 0.0)));
  }
}

TEST_CASE("both signatures stand side by side, whichever is measured") {
  Bench bench;
  EvaluationInput input = bench.input();
  const NoiseOptions options{.levels = {1}, .queries = {}};
  const ordered_json by_paper = make_noise_report(input, options).data;
  const ordered_json changes_by_paper = make_invariance_report(input, {}).data;
  input.signature = SignatureKind::mdbd_fused;
  const ordered_json by_fused = make_noise_report(input, options).data;
  const ordered_json changes_by_fused = make_invariance_report(input, {}).data;
  CHECK(by_paper["signatures"] == by_fused["signatures"]);
  CHECK(by_paper["signatures"][0]["mdbd-100"] == by_paper["noise"][0]["measures"]);
  CHECK(by_fused["signatures"][0]["mdbd-fused"] == by_fused["noise"][0]["measures"]);
  REQUIRE(changes_by_paper["signatures"].size() == 11);
  CHECK(changes_by_paper["signatures"] == changes_by_fused["signatures"]);
}

TEST_CASE("queries are drawn beside their noisy copies") {
  Bench bench;
  const Report chosen = make_noise_report(bench.input(), {.levels = {1}, .queries = {}});
  CHECK(blocks_of<BarChart>(chosen).size() == 3);  // one of each class

  const std::string name = bench.collection.models[1].name;
  const Report report = make_noise_report(bench.input(), {.levels = {0, 1}, .queries = {name}});
  const std::vector<BarChart> charts = blocks_of<BarChart>(report);
  REQUIRE(charts.size() == 1);
  CHECK_THAT(charts[0].caption,
             Catch::StartsWith(name + ": rank correlation 1.000 with noise 0 %"));
  REQUIRE(charts[0].series.size() == 3);
  CHECK(charts[0].categories.size() == 6);
  CHECK(charts[0].bands.size() == 3);
  CHECK(charts[0].series[0].values[1] == 0);
  CHECK(charts[0].series[0].values == charts[0].series[1].values);  // no noise, no change
  CHECK(charts[0].series[2].values[1] > 0);
  CHECK(report.data["queries"][0]["noisy_distances"][1] == charts[0].series[2].values);
}

TEST_CASE("noise that makes no sense and unknown queries are refused") {
  Bench bench;
  CHECK_THROWS_AS(make_noise_report(bench.input(), {.levels = {}, .queries = {}}), InvalidInput);
  CHECK_THROWS_AS(make_noise_report(bench.input(), {.levels = {101}, .queries = {}}), InvalidInput);
  CHECK_THROWS_WITH(make_noise_report(bench.input(), {.levels = {1}, .queries = {"box/9.off"}}),
                    Contains("box/9.off") && Contains("such as box/1.3"));
  CHECK_THROWS_AS(make_noise_report(bench.input(), {.levels = {1}, .queries = {"rod/damaged.off"}}),
                  InvalidInput);
}

TEST_CASE("seeds change the noise, the cache keeps it") {
  Bench bench;
  const NoiseOptions options{.levels = {1}, .queries = {}};
  const ordered_json first = make_noise_report(bench.input(1), options).data;
  bench.progress = {};
  CHECK(make_noise_report(bench.input(1), options).data == first);
  CHECK(bench.progress.stages.empty());
  CHECK(make_noise_report(bench.input(2), options).data["noise"] != first["noise"]);
}

TEST_CASE("the invariance report can be computed again from its data") {
  Bench bench;
  const Report report = make_invariance_report(bench.input(), {});
  CHECK(report.title == "Invariance on models");
  const ordered_json& data = report.data;
  REQUIRE(data["changes"].size() == 11);
  for (const ordered_json& change : data["changes"]) {
    INFO(change["change"]);
    CHECK(change["models"].size() == 6);
    check_measures(data, change);
    const bool is_exact =
        change["change"] == "export as .ply" || change["change"] == "export as .obj";
    for (const ordered_json& model : change["models"]) {
      if (is_exact) CHECK(model["displacement"] == 0);
      if (change["change"] == "subdivision") CHECK(model["faces"] >= 4 * 192);
    }
  }
  CHECK(blocks_of<Table>(report).front().rows.size() == 11);
  CHECK_FALSE(format_report_html(report).empty());
}

TEST_CASE("copies that cannot be described are left out and said") {
  Bench bench;
  const EvaluationInput input = bench.input();
  const CleanModels clean = describe_clean_models(input);
  const Perturbation vanishing{
      .name = "vanishing",
      .apply = [](const TriangleMesh&, std::uint64_t) { return TriangleMesh(); }};
  const std::vector<VariedModels> varied = {describe_varied(input, clean, vanishing)};
  CHECK_FALSE(varied[0].robustness);
  CHECK_THAT(variation_notes(clean, varied).front(),
             Contains("vanishing: 6 of 6 copies could not be described"));
  CHECK(to_json(clean, varied[0]) == ordered_json{{"change", "vanishing"}});
  CHECK(worst_models_table(clean, varied, 5).rows.empty());
}

TEST_CASE("the representations report queries the meshes with clouds of themselves") {
  Bench bench;
  RepresentationsOptions options;
  options.points = {1000, 2000};
  options.noisy_points = 1500;
  const Report report = make_representations_report(bench.input(), options);
  const ordered_json& data = report.data;
  REQUIRE(data["changes"].size() == 3);
  CHECK(data["changes"][0]["change"] == "cloud of 1000 points");
  CHECK(data["changes"][2]["change"] == "cloud of 1500 points, noise 0.5 %");
  for (const ordered_json& change : data["changes"]) {
    check_measures(data, change);
    for (const ordered_json& model : change["models"]) CHECK(model.contains("points"));
  }
  CHECK(data["signatures"].size() == 3);
  REQUIRE(data["mixed"].size() == 3);
  // The three boxes are like one another, and so are the two tori, whatever represents them.
  for (const ordered_json& query : data["mixed"]) {
    CHECK(query["mdbd-fused"]["class_accuracy"] == 1.0);
  }
  const ordered_json again = make_representations_report(bench.input(), options).data;
  CHECK(again == data);
}
