#include "features/decomposition/cell.h"

#include <catch2/catch.hpp>

#include "features/distance/mesh_distance_field.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/whole_space.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

// Works on a cell as the search does, and checks after each step that no point of the cell beats
// its bound.
template <typename Field>
void check_bounds(const Field& field, const std::vector<Ball>& balls, double reach) {
  RemainingSpace space = whole_space(field);
  for (const Ball& ball : balls) space.place(ball, 1.0);
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const double half_size = 0.4 / (1 << round % 6);
    Cell cell(random_point(random, reach), half_size, field.enclosing_ball().radius);
    const auto check = [&](const Cell& checked) {
      for (int i = 0; i < 30; ++i) {
        const Eigen::Vector3d point = checked.center() + random_point(random, checked.half_size());
        const double value =
            std::min(field.measure({.point = point}).distance, ball_distance(balls, point));
        REQUIRE(value <= checked.bound() + 1e-12);
      }
    };
    cell.measure(space, 0.0);
    check(cell);
    while (cell.wants_probe()) {
      const auto [point, value] = cell.probe(space, 0.0);
      CHECK(value == Approx(std::min(field.measure({.point = point}).distance,
                                     ball_distance(balls, point))));
      check(cell);
    }
    const OctantBounds bounds(cell.witnesses(space), cell.center(), cell.half_size());
    for (int octant = 0; octant < 8; ++octant) {
      Cell child = cell.child(octant);
      child.tighten(bounds.of_octant(octant, space.preference()), 0.0);
      check(child);
      child.tighten(space, 0.0);
      check(child);
      child.measure(space, 0.0);
      check(child);
    }
  }
}

}  // namespace

TEST_CASE("no point of a cell beats its bound") {
  SECTION("a box") { check_bounds(BoxField({1.0, 0.6, 0.1}), {}, 1.0); }
  SECTION("a ball") { check_bounds(UnitBallField(), {}, 1.0); }
  SECTION("a torus") { check_bounds(TorusField(1.0, 0.3), {}, 1.3); }
  SECTION("a mesh with large faces") {
    check_bounds(MeshDistanceField(make_cube(), true), {{{0.5, 0.5, 0.5}, 0.5}}, 1.0);
  }
  SECTION("a mesh with small faces") {
    check_bounds(MeshDistanceField(make_torus(1.0, 0.3, 16, 8), true), {}, 1.3);
  }
  SECTION("a box with balls in it") {
    check_bounds(BoxField({1.0, 1.0, 1.0}), {{{0, 0, 0}, 1.0}, {{0.8, 0.8, 0.8}, 0.15}}, 1.0);
  }
}

TEST_CASE("the bound of a small cell on a plate is second order") {
  const double thickness = 0.1;
  const BoxField plate({1.0, 1.0, thickness});
  for (const double half_size : {0.03, 0.01, 0.003}) {
    RemainingSpace space = whole_space(plate);
    Cell cell({0.2, 0.3, 0.5 * half_size}, half_size, 1.0);
    cell.measure(space, 0.0);
    while (cell.wants_probe()) cell.probe(space, 0.0);
    CHECK(cell.bound() >= thickness);
    CHECK(cell.bound() <= thickness + 2.0 * half_size * half_size / thickness);
  }
}
