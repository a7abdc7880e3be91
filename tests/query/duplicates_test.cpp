#include "query/duplicates.h"

#include <algorithm>
#include <memory>
#include <tuple>

#include <catch2/catch.hpp>

#include "features/describe.h"
#include "features/shape_io/write_mesh.h"
#include "perturbation/perturbation.h"
#include "query/signature_metric.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

const Recipe recipe{.balls = 60};

void append(TriangleMesh& mesh, const TriangleMesh& part, const Eigen::Vector3d& size,
            const Eigen::Vector3d& at) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const auto& vertex : part.vertices) mesh.vertices.push_back(vertex.cwiseProduct(size) + at);
  for (const auto& [a, b, c] : part.triangles) {
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
}

/// Boxes side by side: an angle with a foot, which has a hand, of a height.
TriangleMesh make_bracket(double height) {
  TriangleMesh mesh;
  append(mesh, make_cube(), {4, 1, 1}, {0, 0, 0});
  append(mesh, make_cube(), {1, height, 1}, {-1.2, 0, 0});
  append(mesh, make_cube(), {0.8, 0.8, 2}, {2.5, 0.1, 1.2});
  return mesh;
}

/// A database of files with their shapes; the first is the oldest.
class Folder {
 public:
  Folder() : store_(open_store(directory_ / "a.db", recipe)) {}

  void add(const std::string& name, const TriangleMesh& mesh, const std::string& hash = "") {
    write_mesh(directory_ / name, mesh);
    const ShapeDescription description = describe_file(directory_ / name, recipe);
    ShapeRecord record;
    record.path = "/" + name;
    record.content_hash = hash.empty() ? name : hash;
    record.modified_ns = ++time_;
    record.scale = description.decomposition.scale;
    store_->put(record, {.balls = description.decomposition.balls,
                         .signature = description.descriptor.values,
                         .fused = description.fused});
  }

  DuplicateReport find() const { return find_duplicates(*store_); }

 private:
  TemporaryDirectory directory_;
  std::unique_ptr<ShapeStore> store_;
  std::int64_t time_ = 0;
};

const DuplicatePair& pair_with(const DuplicateGroup& group, const std::string& path) {
  const auto pair = std::ranges::find_if(group.pairs, [&](const DuplicatePair& each) {
    return each.first == 0 && group.models[each.second].path == path;
  });
  REQUIRE(pair != group.pairs.end());
  return *pair;
}

}  // namespace

TEST_CASE("copies of a shape are one group with their evidence, near misses are not in it") {
  const TriangleMesh bracket = make_bracket(3.0);
  const auto changed = [&](const Perturbation& perturbation) {
    return perturbation.apply(bracket, 7);
  };
  Folder folder;
  folder.add("original.off", bracket, "bytes");
  folder.add("renamed.off", bracket, "bytes");
  folder.add("exported.stl", bracket);
  folder.add("converted.ply", bracket);
  folder.add("inches.obj", changed(scale_perturbation(25.4)));
  folder.add("mirrored.off", changed(mirror_perturbation()));
  folder.add("turned.off", changed(rotation_perturbation()));
  folder.add("shuffled.off", changed(shuffling_perturbation()));
  folder.add("subdivided.off", changed(subdivision_perturbation()));
  folder.add("decimated.off",
             decimation_perturbation(50).apply(changed(subdivision_perturbation()), 7));
  folder.add("near_miss.off", make_bracket(3.3));
  folder.add("other_miss.off", make_bracket(2.7));
  folder.add("torus.off", make_torus(2.0, 0.5, 40, 20));

  const DuplicateReport report = folder.find();
  CHECK(report.compared == 13);
  REQUIRE(report.groups.size() == 1);
  const DuplicateGroup& group = report.groups.front();
  CHECK(group.models.front().path == "/original.off");
  CHECK(group.models.size() == 10);
  CHECK(group.pairs.size() == 45);
  CHECK(pair_with(group, "/renamed.off").has_same_bytes);
  CHECK_FALSE(pair_with(group, "/turned.off").has_same_bytes);
  CHECK(pair_with(group, "/inches.obj").scale_ratio == Approx(25.4));
  CHECK(pair_with(group, "/mirrored.off").scale_ratio == Approx(1.0));
  CHECK(pair_with(group, "/mirrored.off").hand == Hand::mirrored);
  for (const char* path : {"/turned.off", "/exported.stl", "/inches.obj", "/shuffled.off"}) {
    CHECK(pair_with(group, path).hand == Hand::same);
  }
  for (const DuplicatePair& pair : group.pairs) {
    CHECK(pair.distance <= duplicate_distance);
    CHECK(pair.radii_distance <= radii_share * duplicate_distance);
  }
}

namespace {

/// A collection of which only the distances matter: mdbd-fused has `place` as its first number, the
/// radii of mdbd-100 have `radius`.
class Line {
 public:
  void add(const std::string& name, float place, float radius, const char* representation,
           const char* hash = "") {
    ShapeRecord record;
    record.path = "/" + name;
    record.content_hash = hash;
    record.representation = representation;
    record.scale = 1.0;
    ShapeData data{.balls = {{{0, 0, 0}, 1.0}},
                   .signature = std::vector<float>(100, 0.0F),
                   .fused = std::vector<float>(fused_metric()->least_size(), 0.0F)};
    data.signature[0] = radius;
    data.fused[0] = place;
    store_->put(record, data);
  }
  void add_mesh(const std::string& name, float place) { add(name, place, 0.5F, "mesh"); }

  DuplicateReport find() const { return find_duplicates(*store_); }

  /// The paths of the groups.
  std::vector<std::vector<std::string>> groups() const {
    std::vector<std::vector<std::string>> result;
    for (const DuplicateGroup& group : find().groups) {
      auto& paths = result.emplace_back();
      for (const ShapeRecord& model : group.models) paths.push_back(model.path);
      std::ranges::sort(paths);
    }
    return result;
  }

 private:
  TemporaryDirectory directory_;
  std::unique_ptr<ShapeStore> store_ = open_store(directory_ / "a.db");
};

using Groups = std::vector<std::vector<std::string>>;

}  // namespace

TEST_CASE("a cloud joins a group that is far nearer than any other") {
  Line line;
  line.add_mesh("a1", 0.0F);
  line.add_mesh("a2", 0.05F);
  line.add_mesh("b", 0.36F);
  line.add("cloud", 0.16F, 0.53F, "point cloud");  // 0.11 from a2, 0.2 from b
  CHECK(line.groups() == Groups{{"/a1", "/a2"}});
  line.add_mesh("a3", 0.08F);  // 0.08 and 0.2: clear
  CHECK(line.groups() == Groups{{"/a1", "/a2", "/a3", "/cloud"}});
}

TEST_CASE("a mesh, or a cloud that is too far or has other radii, joins none") {
  Line line;
  line.add_mesh("a", 0.0F);
  const auto [place, radius, representation] =
      GENERATE(std::tuple(0.11F, 0.5F, "mesh"), std::tuple(0.13F, 0.5F, "point cloud"),
               std::tuple(0.11F, 0.54F, "point cloud"));
  line.add("other", place, radius, representation);
  CHECK(line.groups().empty());
}

TEST_CASE("different shapes make different groups, and single ones none") {
  Folder folder;
  const TriangleMesh torus = make_torus(2.0, 0.5, 40, 20);
  folder.add("torus.off", torus);
  folder.add("bracket.off", make_bracket(3.0));
  folder.add("a_bracket.stl", make_bracket(3.0));
  folder.add("other.off", make_bracket(5.0));
  CHECK(folder.find().groups.size() == 1);
  folder.add("torus.ply", torus);
  const DuplicateReport report = folder.find();
  REQUIRE(report.groups.size() == 2);
  CHECK(report.groups[0].models[0].path == "/bracket.off");
  CHECK(report.groups[1].models[0].path == "/torus.off");
  CHECK(report.groups[1].models[1].path == "/torus.ply");
  CHECK(Folder().find().groups.empty());
}

TEST_CASE("solids of one file have the same bytes only if they are the same solid") {
  Line line;
  for (const char* name : {"a.step", "a.step#1", "a.step#2", "b.step#1"}) {
    line.add(name, 0.0F, 0.5F, "B-rep", "bytes");
  }
  const DuplicateReport report = line.find();
  REQUIRE(report.groups.size() == 1);
  const DuplicateGroup& group = report.groups.front();
  REQUIRE(group.pairs.size() == 6);
  for (const DuplicatePair& pair : group.pairs) {
    const std::string first = group.models[pair.first].path;
    const std::string second = group.models[pair.second].path;
    INFO(first << " " << second);
    CHECK(pair.has_same_bytes == (first.ends_with("#1") && second.ends_with("#1")));
  }
}
