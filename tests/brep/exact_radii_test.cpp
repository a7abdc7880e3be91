// Radii and contacts against closed forms, to what no tessellation gives.
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "features/brep/read_brep.h"
#include "features/brep_shape.h"
#include "features/descriptor/contact_graph.h"
#include "features/mesh_shape.h"
#include "tests/brep/occt_solids.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

constexpr double exactness = 1e-6;  // relative to R

Recipe recipe_of(int balls) {
  Recipe recipe;
  recipe.balls = balls;
  recipe.denoise = "off";
  recipe.minimum_radius = 1e-2;
  return recipe;
}

BallDecomposition decompose_exactly(const OcctSolid& solid, int balls) {
  const TemporaryDirectory folder;
  solid.write_step(folder / "a.stp");
  const Recipe recipe = recipe_of(balls);
  return decompose_shape(load_brep_shape(folder / "a.stp", recipe), recipe);
}

/// The largest error of the first radii, relative to R.
double radius_error(const BallDecomposition& decomposition, const std::vector<double>& expected) {
  double error = 0.0;
  REQUIRE(decomposition.balls.size() >= expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    error = std::max(error, std::abs(decomposition.balls[i].radius - expected[i]));
  }
  return error / decomposition.scale;
}

/// The same error when the solid is its own tessellation.
double tessellated_error(const OcctSolid& solid, const std::vector<double>& expected) {
  const TemporaryDirectory folder;
  solid.write_step(folder / "a.stp");
  const Recipe recipe = recipe_of(static_cast<int>(expected.size()));
  const Shape shape = make_mesh_shape(read_brep(folder / "a.stp").brep.mesh, recipe);
  return radius_error(decompose_shape(shape, recipe), expected);
}

std::vector<double> times(int count, double radius) { return std::vector<double>(count, radius); }

void check_exact(const OcctSolid& solid, const std::vector<double>& expected) {
  const auto found = decompose_exactly(solid, static_cast<int>(expected.size()));
  CHECK(radius_error(found, expected) < exactness);
  CHECK(found.is_certified);
  CHECK(tessellated_error(solid, expected) > 3 * exactness);
}

}  // namespace

TEST_CASE("a box has the radii of its mesh") {
  const double root = std::sqrt(3.0);
  std::vector<double> expected = times(9, 0.5 * (root - 1) / (root + 1));
  expected[0] = 0.5;
  const auto box = OcctSolid::box({0, 0, 0}, {1, 1, 1});
  CHECK(radius_error(decompose_exactly(box, 9), expected) < 1e-12);
}

TEST_CASE("a sphere is one ball") {
  const auto found = decompose_exactly(OcctSolid::sphere(2.0), 2);
  REQUIRE(found.balls.size() == 1);
  CHECK(found.balls[0].radius == Approx(2.0).epsilon(1e-9));
  CHECK(tessellated_error(OcctSolid::sphere(2.0), {2.0}) > 3 * exactness);
}

TEST_CASE("a cylinder holds as many balls of its radius as are high") {
  check_exact(OcctSolid::cylinder(1.0, 4.0), {1.0, 1.0});
  check_exact(OcctSolid::cylinder(1.0, 4.0).as_splines(), {1.0, 1.0});
}

TEST_CASE("a torus holds balls of its minor radius") {
  // Centres on a circle of radius 2, two apart at least: six fit.
  check_exact(OcctSolid::torus(2.0, 0.5), times(12, 0.5));
}

TEST_CASE("a cone holds its insphere") {
  const double slant = std::hypot(1.0, 2.0);
  check_exact(OcctSolid::cone(1.0, 0.0, 2.0), {2.0 / (1.0 + slant)});
}

TEST_CASE("beside a cylindrical hole four balls touch the hole and two walls") {
  // From the corner (2, 2): sqrt 2 (2 - r) = 1 + r.
  const double radius = (2 * std::sqrt(2.0) - 1) / (1 + std::sqrt(2.0));
  const auto hole =
      OcctSolid::cylinder(1.0, 4.0).moved(Eigen::Isometry3d(Eigen::Translation3d(0, 0, -2)));
  const auto solid = OcctSolid::box({-2, -2, -2}, {2, 2, 2}).without(hole);
  check_exact(solid, times(8, radius));
}

TEST_CASE("in a box with fillets the balls in the corners touch the corner spheres and the first") {
  const double fillet = 0.3;
  const double corner = ((1 - fillet) * std::sqrt(3.0) + fillet - 1) / 2;
  std::vector<double> expected = times(9, corner);
  expected[0] = 1.0;
  const auto solid = OcctSolid::box({-1, -1, -1}, {1, 1, 1}).with_fillets(fillet);
  check_exact(solid, expected);

  const auto found = decompose_exactly(solid, 9);
  const ContactGraph contacts = build_contact_graph(found.balls, exactness);
  CHECK(contacts.neighbours[0].size() == 8);
}

TEST_CASE("a moved solid has the same balls") {
  const Eigen::Isometry3d motion = Eigen::Translation3d(30, -20, 10) *
                                   Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized());
  const auto solid = OcctSolid::box({-1, -1, -1}, {1, 1, 2}).with_fillets(0.3);
  const auto found = decompose_exactly(solid, 20);
  const auto moved = decompose_exactly(solid.moved(motion), 20);
  REQUIRE(moved.balls.size() == found.balls.size());
  std::vector<double> radii;
  for (const Ball& ball : found.balls) radii.push_back(ball.radius);
  CHECK(radius_error(moved, radii) < exactness);
  const double scale = std::sqrt(2 * 0.7 * 0.7 + 1.2 * 1.2) + 0.3;
  CHECK(found.scale == Approx(scale).epsilon(1e-11));
  CHECK(moved.scale == Approx(scale).epsilon(1e-11));
}
