#include "features/implicit/surface.h"

#include <random>

#include <catch2/catch.hpp>

#include "tests/support/brute_force.h"

namespace mdbd::test {
namespace {

using Eigen::Vector3d;

std::vector<Surface> examples() {
  const Vector3d axis = Vector3d(1, 2, 2) / 3.0;
  return {{.kind = Surface::Kind::plane, .point = {1, 0, 0}, .axis = axis},
          {.kind = Surface::Kind::sphere, .point = {1, 0, 0}, .radius = 2.0},
          {.kind = Surface::Kind::cylinder, .point = {1, 0, 0}, .axis = axis, .radius = 0.5},
          {.kind = Surface::Kind::torus,
           .point = {1, 0, 0},
           .axis = axis,
           .radius = 2.0,
           .tube_radius = 0.5}};
}

}  // namespace

TEST_CASE("Feet are on the surface, as far away as the distance says") {
  std::mt19937 random(1);
  for (const Surface& surface : examples()) {
    for (int i = 0; i < 100; ++i) {
      const Vector3d x = random_point(random, 4.0);
      const Vector3d foot = surface.foot(x);
      CHECK(std::abs(surface.distance(foot)) < 1e-14 * 10);
      CHECK((foot - x).norm() == Approx(std::abs(surface.distance(x))));
      CHECK(surface.gradient(x).norm() == Approx(1.0));
    }
  }
}

TEST_CASE("Gradients are the distances' derivatives") {
  std::mt19937 random(2);
  constexpr double step = 1e-6;
  for (const Surface& surface : examples()) {
    const Vector3d x = random_point(random, 4.0);
    for (int i = 0; i < 3; ++i) {
      const Vector3d move = step * Vector3d::Unit(i);
      const double slope = (surface.distance(x + move) - surface.distance(x - move)) / (2 * step);
      CHECK(surface.gradient(x)[i] == Approx(slope).margin(1e-6));
    }
  }
}

TEST_CASE("Feet are defined on centres and axes, too") {
  for (const Surface& surface : examples()) {
    const Vector3d foot = surface.foot(surface.point);
    CHECK(std::abs(surface.distance(foot)) < 1e-14);
  }
}

TEST_CASE("Surfaces are recognised however they are written") {
  for (const Surface& surface : examples()) {
    Surface turned = surface;
    turned.axis = -surface.axis;
    CHECK(surface.compare(surface) == 1);
    CHECK(surface.compare(turned) == (surface.kind == Surface::Kind::plane ? -1 : 1));
    Surface moved = surface;
    moved.point += Vector3d(1e-6, 0, 0);
    CHECK(surface.compare(moved) == 0);
  }
  Surface slid = examples()[2];
  slid.point += 5.0 * slid.axis;
  CHECK(slid.compare(examples()[2]) == 1);
}

}  // namespace mdbd::test
