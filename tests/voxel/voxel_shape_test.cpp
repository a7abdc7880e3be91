// Radii from grids against closed forms.
#include "features/voxel_shape.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "features/core/errors.h"
#include "features/shape_io/shape_files.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/voxel_writers.h"

namespace mdbd::test {
namespace {

double first_radius(const Shape& shape) {
  Recipe recipe;
  recipe.balls = 1;
  return decompose_shape(shape, recipe).balls.front().radius;
}

double distance_at(const DistanceField& field, const Eigen::Vector3d& x) {
  return field.measure({.point = x}).distance;
}

}  // namespace

TEST_CASE("Radii of signed distances converge with the square of the spacing") {
  std::vector<double> errors;
  for (const std::size_t points : {17, 33, 65}) {
    const Shape shape = make_voxel_shape(sample_grid(points, 1.3, ball_distance_at), Recipe());
    errors.push_back(std::abs(first_radius(shape) - 1.0));
  }
  CHECK(errors[0] < 0.5 * std::pow(2.6 / 16, 2));
  CHECK(errors[1] < 0.5 * std::pow(2.6 / 32, 2));
  CHECK(errors[2] < 0.5 * std::pow(2.6 / 64, 2));
}

TEST_CASE("A box in a grid has its radius within a fraction of the spacing") {
  const BoxField box({1.25, 0.5, 0.5});
  const auto value = [&](const Eigen::Vector3d& x) { return distance_at(box, x); };
  const double spacing = 3.0 / 48;
  const TemporaryDirectory directory;
  for (const auto& [ending, content] : voxel_files(sample_grid(49, 1.5, value))) {
    INFO(ending);
    const Shape shape = load_shape(directory.write("box" + ending, content), Recipe());
    CHECK("." + shape.format == ending);
    CHECK(shape.representation == "voxel grid");
    CHECK(std::abs(first_radius(shape) - 0.5) < 0.1 * spacing);
    CHECK(is_shape_file("box" + ending));
  }
}

TEST_CASE("Occupied cells give radii within the spacing") {
  const TorusField torus(1.0, 0.4);
  const auto filled = [&](const Eigen::Vector3d& x) { return distance_at(torus, x) > 0; };
  const Shape shape = make_voxel_shape(sample_grid(61, 1.5, filled), Recipe());
  CHECK(std::abs(first_radius(shape) - 0.4) < 3.0 / 60);
}

TEST_CASE("The record says what a grid is") {
  const Shape shape = make_voxel_shape(sample_grid(9, 1.3, ball_distance_at), Recipe());
  const auto record = nlohmann::json::parse(shape.statistics);
  CHECK(record.at("grid") == std::vector<int>{9, 9, 9});
  CHECK(record.at("spacing").at(1).get<double>() == Approx(2.6 / 8));
  CHECK(record.at("values") == "signed distance");
  CHECK(record.at("iso_value") == 0.0);
  CHECK(record.at("inside") == "above the iso value");
  CHECK(record.at("watertight") == true);
  CHECK(shape.least_radius == Approx(1.3 / 8));
  CHECK(record.at("orientation") == "outward");
}

}  // namespace mdbd::test
