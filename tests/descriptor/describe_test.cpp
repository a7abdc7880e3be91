#include "features/describe.h"

#include <cmath>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "features/core/errors.h"
#include "features/mesh_shape.h"
#include "perturbation/noise.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/sheets.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

std::filesystem::path write(const TemporaryDirectory& folder, const std::string& name,
                            const std::string& bytes) {
  const std::filesystem::path path = folder.path() / name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

nlohmann::json record(const Shape& shape) { return nlohmann::json::parse(shape.statistics); }

}  // namespace

TEST_CASE("one shape in four formats has one descriptor") {
  const TemporaryDirectory folder;
  const TriangleMesh mesh = make_torus(1.0, 0.4, 20, 10);
  Recipe recipe;
  recipe.balls = 60;
  const ShapeDescription off = describe_file(write(folder, "a.off", to_off(mesh)), recipe);
  CHECK(off.format == "off");
  CHECK(off.representation == "mesh");
  CHECK(nlohmann::json::parse(off.statistics).at("watertight") == true);
  CHECK(off.decomposition.balls.size() == 60);
  const ShapeDescription obj = describe_file(write(folder, "a.obj", to_obj(mesh)), recipe);
  const ShapeDescription ply = describe_file(write(folder, "a.PLY", to_ply_text(mesh)), recipe);
  CHECK(obj.descriptor.values == off.descriptor.values);
  CHECK(ply.descriptor.values == off.descriptor.values);
  const ShapeDescription stl = describe_file(write(folder, "a.stl", to_stl_binary(mesh)), recipe);
  REQUIRE(stl.descriptor.values.size() == 100);
  CHECK(stl.descriptor.radii()[0] == Approx(off.descriptor.radii()[0]).epsilon(1e-6));
}

TEST_CASE("what encloses nothing gets a thickness, or is refused with a reason") {
  Recipe recipe;
  recipe.balls = 60;
  for (const TriangleMesh& sheet : {make_square(), make_sheet_table()}) {
    const Shape shape = make_mesh_shape(sheet, recipe);
    CHECK(record(shape).at("solidified") == true);
    const double thickness = record(shape).at("sheet_thickness");
    CHECK(thickness > 0.0);
    CHECK(shape.field->is_closed());
    const ShapeDescription description = describe_shape(shape, recipe);
    CHECK(description.decomposition.balls.size() == 60);
    CHECK(description.decomposition.is_certified);
    CHECK(description.decomposition.balls[0].radius == Approx(thickness / 2).epsilon(0.2));
  }
  recipe.solidify = "off";
  CHECK_THROWS_AS(make_mesh_shape(make_square(), recipe), InvalidInput);
  CHECK_THROWS_WITH(make_mesh_shape(make_square(), recipe),
                    Catch::Contains("encloses nothing") && Catch::Contains("--solidify"));
}

TEST_CASE("a solid is not solidified") {
  const Shape shape = make_mesh_shape(make_cube(), Recipe{});
  CHECK(record(shape).at("solidified") == false);
  CHECK(record(shape).at("enclosing_share") == 1.0);
  CHECK(record(shape).at("faces_turned") == 0);
}

TEST_CASE("a closed mesh with a turned face is the same solid") {
  Recipe recipe;
  recipe.balls = 9;
  TriangleMesh cube = make_cube();
  const auto expected = describe_shape(make_mesh_shape(cube, recipe), recipe).descriptor.values;
  std::swap(cube.triangles[3][1], cube.triangles[3][2]);
  const Shape shape = make_mesh_shape(cube, recipe);
  CHECK(record(shape).at("orientation") == "mixed");
  CHECK(record(shape).at("faces_turned") == 1);
  CHECK(shape.field->is_closed());
  CHECK(describe_shape(shape, recipe).descriptor.values == expected);
}

TEST_CASE("a noisy mesh is denoised unless that is off, and the record says so") {
  const TriangleMesh clean = make_torus(1.0, 0.4, 80, 40);
  const TriangleMesh noisy = displace_vertices(clean, 0.01, 3);
  Recipe recipe;
  const auto largest_ball = [](const Shape& shape) {
    return decompose_shape(shape, {.balls = 1}).balls[0].radius;
  };
  const Shape untouched = make_mesh_shape(clean, recipe);
  CHECK(record(untouched).at("noise") == 0.0);
  CHECK(record(untouched).at("denoise_filter") == "none");

  const Shape smoothed = make_mesh_shape(noisy, recipe);
  CHECK(record(smoothed).at("noise").get<double>() == Approx(0.02 / std::sqrt(5.0)).epsilon(0.25));
  CHECK(record(smoothed).at("denoise_filter") == "umbrella");
  CHECK(record(smoothed).at("denoise_strength") > 1.0);
  CHECK(largest_ball(smoothed) == Approx(largest_ball(untouched)).epsilon(0.02));

  recipe.denoise = "off";
  const Shape rough = make_mesh_shape(noisy, recipe);
  CHECK(record(rough).at("noise") == 0.0);
  CHECK(largest_ball(rough) < 0.97 * largest_ball(untouched));
}
