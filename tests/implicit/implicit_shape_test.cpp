// Decompositions of solids that come as documents.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "features/core/errors.h"
#include "features/shape.h"
#include "features/shape_io/shape_files.h"
#include "tests/implicit/solids.h"
#include "tests/support/temporary_directory.h"

namespace mdbd::test {
namespace {

Recipe small_recipe(std::size_t balls) {
  Recipe recipe;
  recipe.balls = static_cast<int>(balls);
  return recipe;
}

std::vector<double> radii_of(const std::string& solid, std::size_t balls) {
  const TemporaryDirectory directory;
  const Recipe recipe = small_recipe(balls);
  const Shape shape = load_shape(directory.write("solid.json", csg_document(solid)), recipe);
  std::vector<double> radii;
  for (const Ball& ball : decompose_shape(shape, recipe).balls) radii.push_back(ball.radius);
  return radii;
}

}  // namespace

TEST_CASE("Solids have their known radii") {
  CHECK(radii_of(R"({"sphere": {"radius": 2}})", 3) == std::vector<double>{2.0});

  const auto box = radii_of(R"({"box": {"min": [0, 0, 0], "max": [2.5, 1, 1]}})", 3);
  REQUIRE(box.size() == 3);
  CHECK(box[0] == Approx(0.5).epsilon(1e-9));
  CHECK(box[1] == Approx(0.5).epsilon(1e-9));
  CHECK(box[2] < 0.4);

  const double root = std::sqrt(3.0);
  const auto cube = radii_of(R"({"box": {"min": [0, 0, 0], "max": [1, 1, 1]}})", 9);
  REQUIRE(cube.size() == 9);
  for (std::size_t i = 1; i < 9; ++i) {
    CHECK(cube[i] == Approx((root - 1) / (2 * (root + 1))).epsilon(1e-3));
  }

  const auto torus = radii_of(R"({"torus": {"radius": 2, "tube_radius": 0.5}})", 4);
  REQUIRE(torus.size() == 4);
  for (const double radius : torus) CHECK(radius == Approx(0.5).epsilon(1e-3));

  CHECK(radii_of(moon, 1).at(0) == Approx(0.55).epsilon(1e-3));

  // Half a cylinder's box: a quarter of it is a half space away.
  const auto halved = radii_of(
      R"({"intersection": [{"box": {"min": [0, 0, 0], "max": [2.5, 1, 1]}},
          {"halfspace": {"point": [1.25, 0, 0], "outward": [1, 0, 0]}}]})",
      2);
  CHECK(halved.at(0) == Approx(0.5).epsilon(1e-9));

  // Between the hole and a corner of the block: r + 0.5 from the axis and r from three sides.
  const double first = radii_of(bored_block, 1).at(0);
  CHECK(std::hypot(2 - first, 1 - first) == Approx(first + 0.5).epsilon(1e-6));
}

TEST_CASE("A turned solid has the same radii") {
  const std::string turned =
      R"({"rotate": {"axis": [1, 2, 3], "degrees": 50}, "of": )" + bored_block + "}";
  const auto plain = radii_of(bored_block, 20);
  const auto moved = radii_of(turned, 20);
  REQUIRE(plain.size() == moved.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(moved[i] == Approx(plain[i]).epsilon(2e-3));
  }
}

TEST_CASE("The record says what a solid is") {
  const TemporaryDirectory directory;
  const Shape shape = load_shape(directory.write("a.JSON", csg_document(bored_block)), Recipe());
  CHECK(shape.format == "csg");
  CHECK(shape.representation == "implicit solid");
  CHECK(nlohmann::json::parse(shape.statistics).at("surfaces") == 9);
  CHECK(shape.field->is_closed());
}

TEST_CASE("Only documents that say so are taken for solids in a folder") {
  const TemporaryDirectory directory;
  CHECK(is_shape_file(directory.write("a.json", csg_document(moon))));
  CHECK_FALSE(is_shape_file(directory.write("b.json", R"({"name": "package"})")));
  CHECK_FALSE(is_shape_file(directory.write("c.json", "")));
  CHECK(has_shape_extension("c.json"));  // asked for by name
  CHECK_THROWS_WITH(load_shape(directory / "b.json", Recipe()),
                    Catch::Contains("the JSON document is no solid"));
}

}  // namespace mdbd::test
