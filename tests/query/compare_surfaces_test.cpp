#include "query/compare_surfaces.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "collection/discover.h"
#include "features/describe.h"
#include "features/shape_io/write_mesh.h"
#include "perturbation/perturbation.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

const Recipe recipe{.balls = 60};

/// Files with their records.
class Folder {
 public:
  std::int64_t add(const std::string& name, const TriangleMesh& mesh) {
    write_mesh(path(name), mesh);
    return put(name);
  }

  /// Stores what the file is now.
  std::int64_t put(const std::string& name) {
    const ShapeDescription description = describe_file(path(name), recipe);
    const std::array<std::filesystem::path, 1> paths = {path(name)};
    const FoundFile file = discover(paths).files.front();
    ShapeRecord record;
    record.path = file.path;
    record.file_size = file.size;
    record.modified_ns = file.modified_ns;
    record.scale = description.decomposition.scale;
    return store_->put(record, {.balls = description.decomposition.balls,
                                .signature = description.descriptor.values,
                                .fused = description.fused});
  }

  std::filesystem::path path(const std::string& name) const { return directory_ / name; }

  std::vector<std::optional<double>> compare(std::vector<ModelPair> pairs,
                                             const ProcessLimits& limits = {}) const {
    ProgressBar progress(stderr, false);
    return compare_surfaces(*store_, pairs, limits, progress);
  }

 private:
  TemporaryDirectory directory_;
  std::unique_ptr<ShapeStore> store_ = open_store(directory_ / "a.db", recipe);
};

}  // namespace

TEST_CASE("surfaces of files are compared, in the order of the pairs") {
  Folder folder;
  TriangleMesh steps = make_cube();
  add_cube(steps, {1.2, 0, 0}, 0.5, false);
  const auto original = folder.add("original.off", steps);
  const auto turned = folder.add("turned.ply", rotation_perturbation().apply(steps, 3));
  const auto torus = folder.add("torus.off", make_torus(2.0, 0.5, 40, 20));
  const auto deviations =
      folder.compare({{original, turned}, {original, torus}, {turned, original}});
  REQUIRE(deviations.size() == 3);
  CHECK(deviations[0].value() < 1e-6);
  CHECK(deviations[1].value() > 0.05);
  CHECK(deviations[2].value() < 1e-6);
  CHECK(folder.compare({}).empty());
}

TEST_CASE("a pair that cannot be compared costs no other") {
  Folder folder;
  const auto good = folder.add("good.off", make_cube());
  const auto copy = folder.add("copy.off", make_cube());
  const auto bad = folder.add("bad.off", make_cube());
  SECTION("the file is gone") { std::filesystem::remove(folder.path("bad.off")); }
  SECTION("the file has changed") { write_mesh(folder.path("bad.off"), make_torus(2, 1, 9, 9)); }
  SECTION("the file was replaced by something else of the same size and time") {
    const auto time = std::filesystem::last_write_time(folder.path("bad.off"));
    const auto size = std::filesystem::file_size(folder.path("bad.off"));
    std::ofstream(folder.path("bad.off")) << std::string(size, 'x');
    std::filesystem::last_write_time(folder.path("bad.off"), time);
  }
  const auto deviations = folder.compare({{bad, good}, {good, copy}, {copy, bad}, {good, 99}});
  CHECK_FALSE(deviations[0]);
  CHECK(deviations[1].value() < 1e-6);
  CHECK_FALSE(deviations[2]);
  CHECK_FALSE(deviations[3]);
}

TEST_CASE("a comparison that takes too long is given up") {
  Folder folder;
  const auto cube = folder.add("cube.off", make_cube());
  const auto torus = folder.add("torus.off", make_torus(2.0, 0.5, 200, 100));
  CHECK_FALSE(folder.compare({{cube, torus}}, {.time = std::chrono::milliseconds(1)})[0]);
}

TEST_CASE("domains in the plane are not compared") {
  Folder folder;
  std::ofstream(folder.path("a.wkt")) << "POLYGON((0 0, 2 0, 2 1, 0 1, 0 0))";
  const auto domain = folder.put("a.wkt");
  CHECK_FALSE(folder.compare({{domain, domain}})[0]);
}
