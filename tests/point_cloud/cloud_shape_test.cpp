#include "features/cloud_shape.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "features/core/errors.h"
#include "features/describe.h"
#include "features/mesh_shape.h"
#include "perturbation/surface_sampling.h"
#include "tests/support/cloud_writers.h"
#include "tests/support/mesh_writers.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

Recipe short_recipe() {
  Recipe recipe;
  recipe.balls = 30;
  return recipe;
}

/// How far the first radii of a mesh's cloud are from those of the mesh, relative to the largest.
double radius_error(const TriangleMesh& mesh, std::size_t points, std::size_t count) {
  const Recipe recipe = short_recipe();
  const auto expected = decompose_shape(make_mesh_shape(mesh, recipe), recipe).balls;
  const auto found =
      decompose_shape(make_cloud_shape(sample_points(mesh, points, 1)), recipe).balls;
  REQUIRE(std::min(found.size(), expected.size()) >= count);
  double error = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    error = std::max(error, std::abs(found[i].radius - expected[i].radius));
  }
  return error / expected.front().radius;
}

}  // namespace

TEST_CASE("the balls of a cloud approach those of its mesh as the points grow denser") {
  // A hole of radius h in the samples lets a ball of radius r grow by about h^2 / 2r.
  SECTION("a sphere") {
    const TriangleMesh sphere = make_sphere(1.0, 60);
    CHECK(radius_error(sphere, 1'000, 1) < 0.02);
    CHECK(radius_error(sphere, 64'000, 1) < 0.001);
  }
  SECTION("a cube, with the balls in its corners") {
    const double sparse = radius_error(make_cube(), 3'000, 9);
    const double dense = radius_error(make_cube(), 48'000, 9);
    CHECK(sparse < 0.1);
    CHECK(dense < 0.02);
    CHECK(dense < sparse / 2);
  }
}

TEST_CASE("a file of points is decomposed like any other, and the record says what it was") {
  const TemporaryDirectory directory;
  PointCloud cloud = sample_points(make_torus(2.0, 0.7, 60, 30), 3000, 1);
  cloud.points.push_back(cloud.points.front());
  cloud.points.emplace_back(0, 0, 0);
  const auto path = directory.write("torus.xyz", "nan 0 0\n" + to_table(cloud, " "));
  const ShapeDescription description = describe_file(path, short_recipe());
  CHECK(description.format == "xyz");
  CHECK(description.representation == "point cloud");
  CHECK(description.decomposition.balls.size() == 30);
  CHECK(description.decomposition.balls.front().radius == Approx(0.7).epsilon(0.03));
  const auto record = nlohmann::json::parse(description.statistics);
  CHECK(record.at("points") == 3000);
  CHECK(record.at("points_not_finite") == 1);
  CHECK(record.at("points_duplicate") == 1);
  CHECK(record.at("points_outlier") == 1);
  CHECK(record.at("normals_given") == false);
  CHECK(record.at("inside") == "winding number");
  CHECK(record.at("orientation") == "flood from outside");
  CHECK(record.at("spacing").get<double>() > 0);
  CHECK(record.at("least_radius") == record.at("spacing"));
}

TEST_CASE("no ball of a cloud is smaller than the spacing of its points") {
  Recipe recipe;
  const Shape shape = make_cloud_shape(sample_points(make_sphere(1.0, 30), 500, 1));
  CHECK(shape.least_radius == Approx(std::sqrt(4 * M_PI / 500)).epsilon(0.1));
  CHECK(minimum_radius(shape, recipe) ==
        Approx(shape.least_radius / shape.field->enclosing_ball().radius));
  const BallDecomposition result = decompose_shape(shape, recipe);
  CHECK(result.termination == Termination::minimum_radius);
  for (const Ball& ball : result.balls) CHECK(ball.radius >= shape.least_radius * (1 - 1e-9));
  recipe.minimum_radius = 0.5;
  CHECK(minimum_radius(shape, recipe) == 0.5);
}

TEST_CASE("the same cloud gives the same bits, in any order of its points nearly the same balls") {
  PointCloud cloud = sample_points(make_torus(2.0, 0.7, 60, 30), 3000, 1);
  const Recipe recipe = short_recipe();
  const auto first = decompose_shape(make_cloud_shape(cloud), recipe).balls;
  const auto second = decompose_shape(make_cloud_shape(cloud), recipe).balls;
  REQUIRE(first.size() == second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(first[i].radius == second[i].radius);
    CHECK(first[i].center == second[i].center);
  }
  std::ranges::reverse(cloud.points);
  const auto reversed = decompose_shape(make_cloud_shape(cloud), recipe).balls;
  CHECK(reversed.front().radius == Approx(first.front().radius).epsilon(1e-3));
}

TEST_CASE("clouds that are no solids are refused with the reason") {
  const TemporaryDirectory directory;
  const auto few = directory.write("few.xyz", "0 0 0\n1 0 0\n0 1 0\n");
  CHECK_THROWS_WITH(load_shape(few, Recipe()), Catch::Contains("too few points: 3"));
  const auto ply = directory.write("cloud.ply", to_ply({.points = {{0, 0, 0}}, .normals = {}}));
  CHECK_THROWS_AS(load_shape(ply, Recipe()), InvalidInput);
  const auto mesh = directory.write("mesh.ply", to_ply_text(make_cube()));
  CHECK(load_shape(mesh, Recipe()).representation == "mesh");
}
