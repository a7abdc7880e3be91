#include "features/brep_shape.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

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
