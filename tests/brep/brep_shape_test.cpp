#include "features/brep_shape.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "features/brep/read_brep.h"
#include "features/brep/solid_path.h"
#include "features/core/errors.h"
#include "features/shape.h"
#include "features/shape_io/shape_files.h"
#include "tests/brep/occt_solids.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

nlohmann::json statistics_of(const Shape& shape) { return nlohmann::json::parse(shape.statistics); }

double first_radius(const Shape& shape) {
  Recipe recipe;
  recipe.balls = 1;
  return decompose_shape(shape, recipe).balls.at(0).radius;
}

const OcctSolid rod = OcctSolid::cylinder(1.0, 3.0);

}  // namespace

TEST_CASE("the endings of CAD files are known in upper and lower case") {
  for (const char* name : {"a.step", "a.STP", "a.Iges", "a.igs"}) CHECK(has_shape_extension(name));
}

TEST_CASE("the record of a CAD file tells its unit, and coordinates are millimetres") {
  const TemporaryDirectory folder;
  rod.write_step(folder / "mm.step");
  rod.write_step(folder / "inch.STEP", "INCH");
  const Shape in_mm = load_shape(folder / "mm.step", {});
  const Shape in_inches = load_shape(folder / "inch.STEP", {});
  CHECK(in_mm.representation == "B-rep");
  CHECK(in_mm.format == "step");
  CHECK(statistics_of(in_mm)["unit"] == "mm");
  CHECK(statistics_of(in_inches)["unit"] == "mm");
  CHECK(statistics_of(in_mm)["file_unit"] != statistics_of(in_inches)["file_unit"]);
  CHECK(first_radius(in_mm) == Approx(1.0).epsilon(1e-9));
  CHECK(first_radius(in_inches) == Approx(1.0).epsilon(1e-9));  // written from the same millimetres
}

TEST_CASE("IGES files hold solids, or faces that are sewn") {
  const TemporaryDirectory folder;
  rod.write_iges(folder / "solid.igs");
  rod.write_iges(folder / "faces.iges", true);
  const Shape solid = load_shape(folder / "solid.igs", {});
  const Shape faces = load_shape(folder / "faces.iges", {});
  for (const Shape* shape : {&solid, &faces}) {
    CHECK(shape->format == "iges");
    CHECK(shape->representation == "B-rep");
    CHECK(statistics_of(*shape)["solids"] == 1);
    CHECK(shape->field->is_closed());
    CHECK(first_radius(*shape) == Approx(1.0).epsilon(1e-6));
  }
  CHECK(statistics_of(faces)["sewn"] == true);
}

TEST_CASE("an assembly is the union of its solids") {
  const TemporaryDirectory folder;
  const OcctSolid ball =
      OcctSolid::sphere(1.5).moved(Eigen::Isometry3d(Eigen::Translation3d(10, 0, 0)));
  rod.beside(ball).write_step(folder / "a.step");
  const Shape shape = load_shape(folder / "a.step", {});
  CHECK(statistics_of(shape)["solids"] == 2);
  CHECK(first_radius(shape) == Approx(1.5).epsilon(1e-9));
}

TEST_CASE("a solid that is inside out is turned, and the record says so") {
  const TemporaryDirectory folder;
  rod.inside_out().write_step(folder / "a.step");
  const Shape shape = load_shape(folder / "a.step", {});
  CHECK(first_radius(shape) == Approx(1.0).epsilon(1e-9));
}

TEST_CASE("a face alone goes the way of meshes") {
  const TemporaryDirectory folder;
  OcctSolid::box({0, 0, 0}, {4, 2, 1}).face(1).write_step(folder / "a.step");
  const Shape shape = load_shape(folder / "a.step", {});
  CHECK(shape.representation == "mesh");
  CHECK(shape.format == "step");
  const auto statistics = statistics_of(shape);
  CHECK(statistics["solidified"] == true);
  CHECK(statistics["unit"] == "mm");
  CHECK(statistics.contains("tessellated"));
}

TEST_CASE("pictures of a solid show its tessellation") {
  const TemporaryDirectory folder;
  rod.write_step(folder / "a.step");
  const Shape shape = load_shape(folder / "a.step", {});
  const auto* surface = std::get_if<TriangleMesh>(&shape.surface);
  REQUIRE(surface != nullptr);
  REQUIRE_FALSE(surface->triangles.empty());
  for (const Eigen::Vector3d& vertex : surface->vertices) {  // on the rod
    const double radius = vertex.head<2>().norm();
    CHECK(std::max(radius - 1.0, std::abs(vertex.z() - 1.5) - 1.5) == Approx(0.0).margin(1e-9));
  }
}

TEST_CASE("a number after the ending of a CAD file names one of its solids") {
  const auto split = split_solid_path("parts/a#1.STEP#12");
  CHECK(split.file == "parts/a#1.STEP");
  CHECK(split.solid == 12);
  CHECK(solid_path("parts/a#1.STEP", 12) == "parts/a#1.STEP#12");
  CHECK(solid_path("a.step", 0) == "a.step");
  for (const char* file :
       {"a.step", "a#2.step", "a.stl#2", "a.step#", "a.step#0", "a.step#02", "a.step#2b",
        "a.step#-2", "a.step#99999999999999999999", "a.step#2/b", "#2", ".step#2", ""}) {
    INFO(file);
    CHECK(split_solid_path(file).file == file);
    CHECK(split_solid_path(file).solid == 0);
  }
}

TEST_CASE("each solid of an assembly is a shape of its own") {
  const TemporaryDirectory folder;
  const OcctSolid both = rod.beside(OcctSolid::box({10, 0, 0}, {13, 3, 3}));
  both.write_step(folder / "a.step");
  both.write_iges(folder / "faces.iges", true);
  for (const char* name : {"a.step", "faces.iges"}) {
    INFO(name);
    CHECK(count_solids(folder / name) == 2);
    std::vector<double> radii;
    for (const std::size_t number : {1, 2}) {
      const Shape shape = load_shape(solid_path(folder / name, number), {});
      CHECK(statistics_of(shape)["solids"] == 2);
      CHECK(statistics_of(shape)["solid"] == number);
      radii.push_back(first_radius(shape));
    }
    std::ranges::sort(radii);
    CHECK(radii[0] == Approx(1.0).epsilon(1e-6));
    CHECK(radii[1] == Approx(1.5).epsilon(1e-6));
  }
  CHECK_THROWS_WITH(load_shape(folder / "a.step#3", {}), Catch::Contains("no solid 3"));
  CHECK_THROWS_AS(load_shape(folder / "b.step#1", {}), IoError);
  OcctSolid::box({0, 0, 0}, {4, 2, 1}).face(1).write_step(folder / "face.step");
  CHECK(count_solids(folder / "face.step") == 0);
  CHECK_THROWS_WITH(load_shape(folder / "face.step#1", {}), Catch::Contains("no solid 1"));
}
