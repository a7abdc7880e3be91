// 3MF, 3DS, DAE, GLB and glTF: scenes of nodes, read through assimp.
#include <numbers>

#include <catch2/catch.hpp>

#include "tests/shape_io/reading.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/scene_writers.h"

namespace mdbd::test {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

Affine3d placed(const Vector3d& at, const Vector3d& scale, double angle = 0.0) {
  return Eigen::Translation3d(at) * Eigen::AngleAxisd(angle, Vector3d::UnitZ()) *
         Eigen::Scaling(scale);
}

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

/// An L of two boxes, 3 x 1 x 1 and 1 x 2 x 1, one of them from a cube that is mirrored, the whole
/// turned and moved.
Scene make_l_shape() {
  return {.mesh = make_cube(),
          .nodes = {placed({0, 0, 0}, {3, 1, 1}), placed({1, 1, 0}, {-1, 2, 1})},
          .outer = placed({10, 0, 5}, {1, 1, 1}, std::numbers::pi / 2)};
}

}  // namespace

TEST_CASE("A scene of one mesh is that mesh in every format") {
  const TriangleMesh torus = make_torus(2.0, 0.5, 24, 12);
  for (const auto& [ending, content] : scene_files({.mesh = torus})) {
    INFO(ending);
    const MeshFile file = read_content(ending, content);
    CHECK("." + file.format == ending);
    CHECK(file.statistics.faces == torus.triangles.size());
    CHECK(file.statistics.vertices == torus.vertices.size());
    CHECK(file.statistics.watertight);
    CHECK(file.statistics.orientation == Orientation::outward);
    CHECK(six_volumes(file.mesh) == Approx(six_volumes(torus)).epsilon(1e-6));
    CHECK(box_of(file.mesh).isApprox(box_of(torus), 1e-6));
  }
}

TEST_CASE("Nodes place, scale, turn and mirror their meshes") {
  const Scene scene = make_l_shape();
  for (const auto& [ending, content] : scene_files(scene)) {
    INFO(ending);
    const MeshFile file = read_content(ending, content);
    CHECK(file.statistics.faces == 24);
    CHECK(six_volumes(file.mesh) == Approx(6.0 * 5.0));  // mirrored or not, both outward
    CHECK(file.statistics.orientation == Orientation::outward);
    // The L reaches from (0, 0, 0) to (3, 3, 1); a quarter turn makes that (-3, 0, 0) to (0, 3, 1).
    const Eigen::AlignedBox3d expected(Vector3d(7, 0, 5), Vector3d(10, 3, 6));
    CHECK(box_of(file.mesh).isApprox(expected, 1e-6));
  }
}

TEST_CASE("Units are told and not applied") {
  const Scene scene = {.mesh = make_cube()};
  const auto unit_of = [](std::string_view ending, const std::string& content) {
    const MeshFile file = read_content(ending, content);
    CHECK(box_of(file.mesh).sizes().isApprox(Vector3d::Ones(), 1e-6));
    return file.unit;
  };
  CHECK(unit_of(".3mf", to_3mf(scene)) == "millimeter");
  CHECK(unit_of(".3mf", to_3mf(scene, " unit=\"inch\"")) == "inch");
  CHECK(unit_of(".dae", to_dae(scene)) == "meter");
  CHECK(unit_of(".dae", to_dae(scene, "<unit name=\"centimeter\" meter=\"0.01\"/>")) ==
        "centimeter (0.01 m)");
  CHECK(unit_of(".dae", to_dae(scene, "<unit meter=\"0.01\" name=\"\xff\"/>")) == "meter (0.01 m)");
  CHECK(unit_of(".glb", to_glb(scene)) == "meter");
  CHECK(unit_of(".3ds", to_3ds(scene)).empty());
  CHECK(read_content(".off", to_off(make_cube())).unit.empty());
}

TEST_CASE("A glTF file finds its buffers beside and below it only") {
  const TemporaryDirectory directory;
  const Scene scene = {.mesh = make_cube()};
  std::filesystem::create_directories(directory / "models/parts");
  directory.write("models/a cube.bin", to_gltf_buffer(scene));
  directory.write("models/parts/cube.bin", to_gltf_buffer(scene));
  directory.write("outside.bin", to_gltf_buffer(scene));
  const auto read = [&](const std::string& uri) {
    return read_mesh(directory.write("models/cube.gltf", to_gltf(scene, uri)));
  };
  CHECK(read("a%20cube.bin").statistics.watertight);
  CHECK(read("a cube.bin").statistics.watertight);
  CHECK(read("parts/cube.bin").statistics.watertight);
  CHECK(read("./parts/../a cube.bin").statistics.watertight);
  for (const std::string uri : {"missing.bin", "../outside.bin", "..%2foutside.bin",
                                "parts/../../outside.bin", "parts", "/dev/zero"}) {
    INFO(uri);
    CHECK_THROWS_AS(read(uri), InvalidInput);
  }
  CHECK_THROWS_AS(read((directory / "outside.bin").string()), InvalidInput);
  CHECK_THROWS_WITH(read("missing.bin"), Catch::Contains("missing.bin"));
}

TEST_CASE("What assimp knows beyond these formats is not accepted") {
  const std::string obj = to_obj(make_cube());
  CHECK_THAT(reason_against(".fbx", obj), Catch::Contains("the name does not end in"));
  const std::string fbx = "Kaydara FBX Binary  " + std::string("\0\x1a\0", 3) + std::string(60, 0);
  const std::string ply = to_ply_text(make_cube());
  const std::string stl = to_stl_binary(make_cube());
  for (const std::string ending : {".3mf", ".3ds", ".dae", ".glb", ".gltf"}) {
    INFO(ending);
    for (const std::string& content : {obj, fbx, ply, stl}) {
      CHECK_FALSE(reason_against(ending, content).empty());
    }
  }
}

TEST_CASE("Damaged scenes are refused with a reason") {
  const Scene scene = {.mesh = make_cube()};
  CHECK_THAT(reason_against(".3mf", "PK and no more"), Catch::Contains("no zip archive"));
  CHECK_THAT(reason_against(".3mf", to_zip({{"readme.txt", "hello"}})),
             Catch::Contains("holds no model"));
  CHECK_THAT(reason_against(".dae", "<COLLADA version=\"1.4.1\"><asset>"),
             Catch::Contains("assimp cannot read the file: "));
  CHECK_THAT(reason_against(".gltf", "{\"asset\": {\"version\": \"2.0\"}, "),
             Catch::Contains("assimp cannot read the file: "));
  CHECK_THAT(reason_against(".glb", to_glb(scene).substr(0, 300)),
             Catch::Contains("assimp cannot read the file: "));
  CHECK_THAT(reason_against(".3ds", to_3ds(scene).substr(0, 30)),
             Catch::Contains("assimp cannot read the file: "));
}

TEST_CASE("A 3MF model that assimp would stumble over is refused") {
  const auto model = [](const std::string& transform, const std::string& more) {
    return to_3mf_package("<model><resources><object id=\"1\"/></resources><build><item " + more +
                          "objectid=\"1\" transform=\"" + transform + "\"/></build></model>");
  };
  CHECK_THAT(reason_against(".3mf", model("1 0 0", "")), Catch::Contains("not twelve numbers"));
  CHECK_THAT(reason_against(".3mf", model("1 0 0 0 1 0 0 0 1 0 0 x", "")),
             Catch::Contains("is no matrix"));
  CHECK_THAT(reason_against(".3mf", model("1 0 0 0 1 0 0 0 1 0 0 0", "p:path=\"/3D/b.model\" ")),
             Catch::Contains("objects in other parts"));
  CHECK_THAT(reason_against(".3mf", model("1 0 0 0 1 0 0 0 1 0 0 0", "")),
             Catch::Contains("neither points nor faces"));
}

}  // namespace mdbd::test
