#include "query/duplicates.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

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

  /// What a comparison of two surfaces gives; those that are not named cannot be compared.
  void set_deviation(const std::string& first, const std::string& second,
                     std::optional<double> deviation) {
    deviations_["/" + first + " /" + second] = deviation;
  }

  DuplicateReport find() const {
    asked_.clear();
    return find_duplicates(*store_, {.compare_surfaces = [&](std::span<const ModelPair> pairs) {
      std::vector<std::optional<double>> result;
      for (const ModelPair& pair : pairs) result.push_back(compare(pair));
      return result;
    }});
  }

  /// The pairs whose surfaces the last call of find() compared.
  const std::vector<std::string>& asked() const { return asked_; }

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
  std::optional<double> compare(const ModelPair& pair) const {
    asked_.push_back(store_->find(pair.first)->path + " " + store_->find(pair.second)->path);
    const auto found = deviations_.find(asked_.back());
    return found != deviations_.end() ? found->second : std::nullopt;
  }

  TemporaryDirectory directory_;
  std::unique_ptr<ShapeStore> store_ = open_store(directory_ / "a.db");
  std::map<std::string, std::optional<double>> deviations_;
  mutable std::vector<std::string> asked_;
};

using Groups = std::vector<std::vector<std::string>>;

}  // namespace

TEST_CASE("surfaces join what signatures leave apart, as far as they are near each other") {
  Line line;
  line.add_mesh("a", 0.0F);
  line.add_mesh("b", 0.4F);
  CHECK(line.groups().empty());
  line.set_deviation("a", "b", 0.005);
  CHECK(line.groups() == Groups{{"/a", "/b"}});
  CHECK(line.find().groups[0].pairs[0].deviation == 0.005);
  CHECK(line.find().measured == 1);
  line.set_deviation("a", "b", 0.007);
  CHECK(line.groups().empty());
  line.set_deviation("a", "b", std::nullopt);
  CHECK(line.groups().empty());
  CHECK(line.find().measured == 0);
  CHECK(line.find().not_measured == 1);
}

TEST_CASE("surfaces are not asked where the distance or the largest radius says no") {
  Line line;
  line.add_mesh("a", 0.0F);
  const auto [place, radius] = GENERATE(std::pair(0.5F, 0.5F), std::pair(0.4F, 0.52F));
  line.add("b", place, radius, "mesh");
  line.set_deviation("a", "b", 0.0);
  CHECK(line.groups().empty());
  CHECK(line.asked().empty());
}

TEST_CASE("a model whose surface deviates leaves its group, and joins its like") {
  Line line;
  for (const char* name : {"a1", "a2", "b1", "b2"}) line.add_mesh(name, 0.0F);
  line.set_deviation("a1", "a2", 0.001);
  line.set_deviation("a1", "b1", 0.02);
  line.set_deviation("a1", "b2", 0.03);
  line.set_deviation("b1", "b2", 0.0);
  CHECK(line.groups() == Groups{{"/a1", "/a2"}, {"/b1", "/b2"}});
  const std::vector<std::string> asked = line.asked();
  CHECK(std::ranges::count(asked, "/a1 /b1") == 1);
  line.set_deviation("a1", "b2", std::nullopt);  // then signatures have the last word
  CHECK(line.groups() == Groups{{"/a1", "/a2", "/b2"}});
}

TEST_CASE("files of the same bytes need no comparison") {
  Line line;
  line.add("a", 0.0F, 0.5F, "mesh", "bytes");
  line.add("b", 0.0F, 0.5F, "mesh", "bytes");
  CHECK(line.groups() == Groups{{"/a", "/b"}});
  CHECK(line.asked().empty());
}

TEST_CASE("a surface is kept rather than samples of it") {
  Line line;
  line.add("a", 0.0F, 0.5F, "point cloud");
  line.add("later", 0.0F, 0.5F, "mesh");
  const DuplicateReport report = line.find();
  REQUIRE(report.groups.size() == 1);
  CHECK(report.groups[0].models[0].path == "/later");
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
