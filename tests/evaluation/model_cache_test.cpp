#include "evaluation/model_cache.h"

#include <csignal>
#include <fstream>

#include <catch2/catch.hpp>

#include "evaluation/evaluation_input.h"
#include "features/core/errors.h"
#include "features/descriptor/similarity_distance.h"
#include "features/mesh_shape.h"
#include "tests/evaluation/recording_progress.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

Recipe small_recipe() {
  Recipe recipe;
  recipe.balls = 5;
  recipe.descriptor_balls = 5;
  recipe.walk_steps = 3;
  return recipe;
}

/// A labelled collection whose files hold the length of a box, or what goes wrong; and a cache.
class Bench {
 public:
  void write(const std::string& name, const std::string& content) {
    folder.write("models/" + name, content);
  }

  LabelledCollection collection() const { return find_labelled_models(folder / "models", 0, 1); }

  ModelCache open(std::size_t jobs = 1) {
    progress = {};
    fs::remove(log);
    return ModelCache({.folder = folder / "cache", .jobs = jobs, .limits = {}}, recipe, progress);
  }

  DescribedModels describe(const std::string& variant, std::size_t jobs = 1) {
    ModelCache cache = open(jobs);
    DescribedModels described = cache.describe(collection().models, this->variant(variant));
    failures = cache.failures();
    return described;
  }

  Variant variant(const std::string& name) const {
    return {.name = name, .load = [this](const fs::path& path, const Recipe& wanted) {
              return make_mesh_shape(box(read(path)), wanted);
            }};
  }

  FileSignature signature(const std::string& name) const {
    return {.name = name, .compute = [this](const fs::path& path) {
              return std::vector<float>{1.0F, std::stof(read(path))};
            }};
  }

  /// How many files were computed since open().
  std::size_t computed() const {
    std::error_code missing;
    const auto size = fs::file_size(log, missing);
    return missing ? 0 : size;
  }

  test::TemporaryDirectory folder;
  fs::path log = folder / "computed";
  Recipe recipe = small_recipe();
  test::RecordingProgress progress;
  std::vector<EvaluationFailure> failures;

 private:
  std::string read(const fs::path& path) const {
    std::ofstream(log, std::ios::app) << '.';
    std::string content;
    std::getline(std::ifstream(path), content, '\0');
    if (content.starts_with("bad")) throw InvalidInput("no solid");
    if (content.starts_with("io")) throw IoError("read error");
    if (content.starts_with("crash")) std::raise(SIGKILL);
    return content;
  }

  static TriangleMesh box(const std::string& length) {
    TriangleMesh mesh = test::make_cube();
    for (Eigen::Vector3d& vertex : mesh.vertices) vertex.x() *= std::stod(length);
    return mesh;
  }
};

bool are_equal(const DescribedModel& a, const DescribedModel& b) {
  const auto equal = [](const Ball& left, const Ball& right) {
    return left.center == right.center && left.radius == right.radius;
  };
  return a.descriptor == b.descriptor && a.scale == b.scale &&
         std::ranges::equal(a.balls, b.balls, equal);
}

bool are_equal(const DescribedModels& a, const DescribedModels& b) {
  return std::ranges::equal(a, b, [](const auto& left, const auto& right) {
    return left.has_value() == right.has_value() && (!left || are_equal(*left, *right));
  });
}

}  // namespace

TEST_CASE("what was described is not described again") {
  Bench bench;
  bench.write("a/1.off", "1");
  bench.write("a/2.off", "2");
  const DescribedModels first = bench.describe("");
  CHECK(bench.computed() == 2);
  CHECK(bench.progress.stages == std::vector<std::string>{"clean models: 2"});
  REQUIRE((first[0] && first[1]));
  CHECK(first[0]->balls.size() == 5);
  CHECK(first[0]->descriptor.size() == 8);
  CHECK(first[1]->balls[0].radius == Approx(0.5));
  CHECK(first[1]->scale == Approx(std::sqrt(6.0) / 2));

  const DescribedModels second = bench.describe("");
  CHECK(bench.computed() == 0);
  CHECK(bench.progress.stages.empty());
  CHECK(bench.progress.done == 0);
  CHECK(are_equal(first, second));
}

TEST_CASE("variants and recipes are kept apart") {
  Bench bench;
  bench.write("a/1.off", "1");
  bench.describe("");
  bench.describe("noise 1 %");
  CHECK(bench.computed() == 1);
  CHECK(bench.progress.stages == std::vector<std::string>{"noise 1 %: 1"});
  bench.describe("noise 2 %");
  CHECK(bench.computed() == 1);
  bench.recipe.balls = 6;
  CHECK(bench.describe("")[0]->balls.size() == 6);
  CHECK(bench.computed() == 1);
  bench.recipe.balls = 5;
  for (const char* name : {"", "noise 1 %", "noise 2 %"}) {
    CHECK(bench.describe(name)[0]->balls.size() == 5);
    CHECK(bench.computed() == 0);
  }
}

TEST_CASE("a recipe that differs in the weight of the walk alone finds what is there") {
  Bench bench;
  bench.write("a/1.off", "1");
  const DescribedModels first = bench.describe("");
  bench.recipe.walk_weight = 0.35;
  CHECK(are_equal(first, bench.describe("")));
  CHECK(bench.computed() == 0);
  CHECK(bench.open().recipe().walk_weight == 0.35);
}

TEST_CASE("a changed file is described again, a touched one is not") {
  Bench bench;
  bench.write("a/1.off", "1");
  bench.write("a/2.off", "2");
  bench.describe("");
  bench.write("a/1.off", "3.5");
  fs::last_write_time(bench.folder / "models/a/2.off", fs::file_time_type::clock::now());
  const DescribedModels changed = bench.describe("");
  CHECK(bench.computed() == 1);
  CHECK(changed[0]->scale == Approx(std::sqrt(3.5 * 3.5 + 2) / 2));
  bench.describe("");
  CHECK(bench.computed() == 0);
}

TEST_CASE("content that is known from another file is not described again") {
  Bench bench;
  bench.write("a/1.off", "1");
  bench.describe("x");
  bench.write("a/2.off", "1");
  bench.write("a/3.obj", "1");  // another ending is read in another way
  const DescribedModels described = bench.describe("x");
  CHECK(bench.computed() == 1);
  CHECK(are_equal(*described[0], *described[1]));
  bench.describe("y");
  CHECK(bench.computed() == 2);
}

TEST_CASE("failures are kept, but for files that could not be read") {
  Bench bench;
  bench.write("a/bad.off", "bad");
  bench.write("a/crash.off", "crash");
  bench.write("a/io.off", "io");
  bench.write("a/ok.off", "1");
  for (const bool is_first : {true, false}) {
    const DescribedModels described = bench.describe("x");
    CHECK(bench.computed() == (is_first ? 4 : 1));
    CHECK(bench.progress.failures.size() == (is_first ? 3 : 1));
    CHECK_FALSE((described[0] || described[1] || described[2]));
    CHECK(described[3]);
    REQUIRE(bench.failures.size() == 3);
    CHECK(bench.failures[0].stage == "x");
    CHECK(bench.failures[0].model == "a/bad.off");
    CHECK(bench.failures[0].reason == "no solid");
    CHECK(bench.failures[2].reason == "read error");
  }
}

TEST_CASE("an interrupted evaluation keeps what was done and goes on from there") {
  Bench bench;
  for (const char* length : {"1", "2", "3", "4"}) {
    bench.write("a/" + std::string(length) + ".off", length);
  }
  {
    ModelCache cache = bench.open();
    bench.progress.interrupt_after = 2;
    CHECK_THROWS_AS(cache.describe(bench.collection().models, bench.variant("")), Interrupted);
    CHECK(bench.progress.done == 2);
  }
  const DescribedModels described = bench.describe("");
  CHECK(bench.computed() == 2);
  CHECK(std::ranges::all_of(described, [](const auto& model) { return model.has_value(); }));
}

TEST_CASE("results do not depend on the number of jobs") {
  Bench one;
  Bench many;
  for (Bench* bench : {&one, &many}) {
    for (int i = 1; i < 7; ++i) {
      bench->write("a/" + std::to_string(i) + ".off", i == 3 ? "bad" : std::to_string(i % 5));
    }
    bench->write("b/0.off", "bad");
  }
  CHECK(are_equal(one.describe("", 1), many.describe("", 4)));
  REQUIRE(one.failures.size() == many.failures.size());
  for (std::size_t i = 0; i < one.failures.size(); ++i) {
    CHECK(one.failures[i].model == many.failures[i].model);
  }
}

TEST_CASE("further signatures are kept with their models") {
  Bench bench;
  bench.write("a/1.off", "1");
  bench.write("a/bad.off", "bad");
  bench.write("a/ok.off", "2");
  const auto run = [&](const std::string& name) {
    ModelCache cache = bench.open();
    const LabelledCollection collection = bench.collection();
    cache.describe(collection.models, bench.variant(""));
    fs::remove(bench.log);
    SignatureVectors vectors = cache.compute_signature(collection.models, bench.signature(name));
    bench.failures = cache.failures();
    return vectors;
  };
  const SignatureVectors first = run("one");
  CHECK(bench.computed() == 2);  // a model that failed is not tried
  CHECK(first[0] == std::vector<float>{1.0F, 1.0F});
  CHECK_FALSE(first[1]);
  CHECK(bench.failures.size() == 1);
  CHECK(run("one") == first);
  CHECK(bench.computed() == 0);
  CHECK(run("two") == first);
  CHECK(bench.computed() == 2);
  bench.write("a/1.off", "4.5");
  CHECK(run("one")[0] == std::vector<float>{1.0F, 4.5F});
  CHECK(bench.computed() == 1);
}

TEST_CASE("a signature that fails fails once") {
  Bench bench;
  bench.write("a/1.off", "1");
  const FileSignature signature{"fails", [&](const fs::path&) -> std::vector<float> {
                                  std::ofstream(bench.log, std::ios::app) << '.';
                                  throw InvalidInput("no surface");
                                }};
  for (const std::size_t computed : {2, 0}) {
    ModelCache cache = bench.open();
    const LabelledCollection collection = bench.collection();
    cache.describe(collection.models, bench.variant(""));
    CHECK_FALSE(cache.compute_signature(collection.models, signature)[0]);
    CHECK(bench.computed() == computed);
    REQUIRE(cache.failures().size() == 1);
    CHECK(cache.failures()[0].stage == "fails");
    CHECK(cache.failures()[0].reason == "no surface");
  }
}

TEST_CASE("other work runs in processes, and its failures are counted") {
  Bench bench;
  const std::vector<std::string> names{"empty", "bytes", "throws", "dies"};
  for (const std::size_t jobs : {1, 3}) {
    ModelCache cache = bench.open(jobs);
    const auto results = cache.run("test", names, [](std::size_t i) -> std::string {
      if (i == 2) throw InvalidInput("no number");
      if (i == 3) raise(SIGKILL);
      return i == 0 ? "" : std::string("\0-\xff", 3);
    });
    REQUIRE(results.size() == 4);
    CHECK(results[0] == "");
    CHECK(results[1] == std::string("\0-\xff", 3));
    CHECK_FALSE(results[2]);
    CHECK_FALSE(results[3]);
    CHECK(bench.progress.stages == std::vector<std::string>{"test: 4"});
    CHECK(bench.progress.done == 4);
    CHECK(bench.progress.failures.size() == 2);
    REQUIRE(cache.failures().size() == 2);
    CHECK(cache.failures()[0].stage == "test");
  }
  ModelCache cache = bench.open();
  bench.progress.interrupt_after = 2;
  CHECK_THROWS_AS(cache.run("test", names, [](std::size_t) { return std::string(); }), Interrupted);
}

TEST_CASE("a folder for the cache that cannot be made is named") {
  test::TemporaryDirectory folder;
  test::RecordingProgress progress;
  const auto open = [&](const fs::path& path) {
    ModelCache({.folder = path, .jobs = 1, .limits = {}}, small_recipe(), progress);
  };
  CHECK_THROWS_AS(open(folder / "missing/cache"), IoError);
  CHECK_THROWS_WITH(open(folder / "missing/cache"), Contains("missing/cache: the folder of"));
  CHECK_THROWS_AS(open(folder.write("file", "x")), IoError);
}

TEST_CASE("reports start from the models that could be described") {
  Bench bench;
  bench.write("a/1.off", "bad");
  bench.write("a/2.off", "2");
  bench.write("b/3.off", "3");
  bench.describe("");
  ModelCache cache = bench.open();
  const LabelledCollection collection = bench.collection();
  const CleanModels clean = describe_clean_models({collection, cache});
  REQUIRE(clean.models.size() == 2);
  CHECK(clean.models[1].name == "b/3.off");
  const DistanceMatrix distances = signature_matrix({collection, cache}, clean);
  CHECK(distances(0, 0) == 0.0);
  CHECK(distances(0, 1) == distances(1, 0));
  CHECK(distances(0, 1) == similarity_distance(clean.descriptions[0].descriptor,
                                               clean.descriptions[1].descriptor, 5, 1.0)
                               .total);
}

TEST_CASE("a collection of failures is no start for a report") {
  Bench bench;
  bench.write("a/1.off", "bad");
  bench.describe("");
  ModelCache cache = bench.open();
  const LabelledCollection collection = bench.collection();
  CHECK_THROWS_AS(describe_clean_models({collection, cache}), InvalidInput);
  CHECK_THROWS_WITH(describe_clean_models({collection, cache}), Contains("a/1.off: no solid"));
}
