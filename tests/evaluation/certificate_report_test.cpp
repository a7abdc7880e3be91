#include "evaluation/reports/certificate_report.h"

#include <filesystem>

#include <catch2/catch.hpp>

#include "report/format_report.h"
#include "tests/evaluation/recording_progress.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Contains;

namespace {

class Bench {
 public:
  Bench() {
    recipe.balls = 30;
    recipe.descriptor_balls = 10;
    write("box/cube", test::make_cube());
    write("torus/1", test::make_torus(1, 0.3, 24, 12));
  }

  void write(const std::string& name, const TriangleMesh& mesh) {
    folder.write("models/" + name + ".off", test::to_off(mesh));
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

}  // namespace

TEST_CASE("the guarantees hold on closed models") {
  Bench bench;
  const Report report = make_certificate_report(bench.input(), {});
  CHECK_THAT(report.summary, Contains("No broken guarantee was found on 2 models"));
  CHECK(report.notes.empty());
  for (const auto& [key, verdict] : report.data["verdicts"].items()) {
    INFO(key);
    CHECK(verdict["models"] == 2);
    CHECK(verdict["broken"] == 0);
    CHECK(verdict["largest"] <= verdict["allowed"]);
  }
  CHECK(report.data["models"][0]["name"] == "box/cube.off");
  CHECK(report.data["models"][0]["search_reach"] > 0.5);
  CHECK(bench.progress.stages == std::vector<std::string>{"clean models: 2", "re-checks: 2"});
  CHECK_THAT(format_report_text(report, 100), Contains("contained"));
}

TEST_CASE("balls that are not those of the model break the verdict") {
  Bench bench;
  make_certificate_report(bench.input(), {});
  // A larger cube takes the place of the smaller one, and the cache cannot tell: the files have one
  // size and time.
  const auto path = bench.folder / "models/box/cube.off";
  const auto time = std::filesystem::last_write_time(path);
  TriangleMesh larger = test::make_cube();
  for (Eigen::Vector3d& vertex : larger.vertices) vertex *= 2;
  bench.write("box/cube", larger);
  std::filesystem::last_write_time(path, time);

  const Report report = make_certificate_report(bench.input(), {});
  CHECK_THAT(report.summary, Contains("GUARANTEES ARE BROKEN: maximal by 1 model"));
  const auto& verdict = report.data["verdicts"]["maximal"];
  CHECK(verdict["broken"] == 1);
  CHECK(verdict["model"] == "box/cube.off");
  CHECK(verdict["largest"] > 1.0);
}

TEST_CASE("the balls of open models are measured and not judged") {
  Bench bench;
  TriangleMesh open = test::make_torus(1, 0.3, 24, 12);
  open.triangles.pop_back();
  bench.write("torus/open", open);
  const Report report = make_certificate_report(bench.input(), {});
  CHECK_THAT(report.notes.at(0), Contains("1 model has an open surface"));
  CHECK(report.data["verdicts"]["contained"]["models"] == 2);
  CHECK(report.data["verdicts"]["disjoint"]["models"] == 3);
  CHECK(report.data["verdicts"]["maximal"]["models"] == 2);
}

TEST_CASE("a certificate does not depend on the number of jobs") {
  Bench bench;
  const auto data = make_certificate_report(bench.input(), {}).data;
  CHECK(make_certificate_report(bench.input(3), {}).data == data);
}
