#include "features/brep/brep_distance_field.h"

#include <cmath>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "features/brep/read_brep.h"
#include "tests/brep/occt_solids.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

Brep reread(const OcctSolid& solid) {
  const TemporaryDirectory folder;
  solid.write_step(folder / "a.step");
  return read_brep(folder / "a.step").brep;
}

struct NamedSolid {
  std::string name;
  OcctSolid solid;
};

std::vector<NamedSolid> solids() {
  const OcctSolid block = OcctSolid::box({-1, -1, -1}, {1, 1, 1});
  const OcctSolid rod =
      OcctSolid::cylinder(0.5, 4.0).moved(Eigen::Isometry3d(Eigen::Translation3d(0.1, 0.2, -2)));
  return {{"box", block},
          {"cylinder", OcctSolid::cylinder(1.0, 3.0)},
          {"cone with apex", OcctSolid::cone(1.0, 0.0, 2.0)},
          {"cut cone", OcctSolid::cone(0.4, 1.2, 1.0)},
          {"sphere", OcctSolid::sphere(1.0)},
          {"torus", OcctSolid::torus(2.0, 0.5)},
          {"box with a hole", block.without(rod)},
          {"box with fillets", block.with_fillets(0.3)},
          {"box less a ball", block.without(OcctSolid::sphere(1.2))},
          {"box less a ball as splines", block.without(OcctSolid::sphere(1.2)).as_splines()},
          {"torus as splines", OcctSolid::torus(2.0, 0.5).as_splines()},
          {"box with fillets as splines", block.with_fillets(0.3).as_splines()},
          {"vase", OcctSolid::vase()},
          {"vase as splines", OcctSolid::vase().as_splines()},
          {"two apart", block.beside(OcctSolid::sphere(0.7).moved(
                            Eigen::Isometry3d(Eigen::Translation3d(3, 0, 0))))}};
}

/// Points in and around a ball, and points close to the boundary.
std::vector<Eigen::Vector3d> sample_points(const BrepDistanceField& field, int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.3, 1.3);
  const Ball ball = field.enclosing_ball();
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d direction(coordinate(random), coordinate(random), coordinate(random));
    points.push_back(ball.center + ball.radius * direction);
    const DistanceSample sample = field.measure({.point = points.back()});
    // A millionth to a hundredth of R from the boundary.
    const double height = ball.radius * std::pow(10.0, -4.0 + 2.0 * coordinate(random));
    const Eigen::Vector3d away = (points.back() - sample.closest).normalized();
    points.push_back(sample.closest + (i % 2 == 0 ? height : -height) * away);
  }
  return points;
}

}  // namespace

TEST_CASE("distances are those of OpenCASCADE's own search") {
  for (const auto& [name, solid] : solids()) {
    const BrepDistanceField field(reread(solid));
    const double scale = field.enclosing_ball().radius;
    CHECK(field.is_closed());
    for (const Eigen::Vector3d& point : sample_points(field, 30)) {
      INFO(name << " at " << point.transpose());
      const DistanceSample sample = field.measure({.point = point});
      const double expected = solid.signed_distance(point);
      CHECK(std::abs(sample.distance) == Approx(std::abs(expected)).margin(1e-7 * scale));
      CHECK((sample.closest - point).norm() == Approx(std::abs(sample.distance)));
      if (std::abs(expected) > 1e-8 * scale) CHECK((sample.distance > 0) == (expected > 0));
    }
  }
}

TEST_CASE("flat pieces belong to the boundary") {
  for (const auto& [name, solid] : solids()) {
    const BrepDistanceField field(reread(solid));
    const double scale = field.enclosing_ball().radius;
    for (const Eigen::Vector3d& point : sample_points(field, 30)) {
      INFO(name << " at " << point.transpose());
      const DistanceSample sample = field.measure({.point = point});
      const auto is_boundary = [&](const Eigen::Vector3d& place) {
        return std::abs(field.measure({.point = place}).distance) < 1e-7 * scale;
      };
      for (std::size_t i = 0; i < sample.piece.size(); ++i) {
        CHECK(is_boundary(sample.piece[i]));
        CHECK(is_boundary(sample.piece[i] + 0.5 * edge(sample.piece, i)));
      }
      const FlatRegion& region = sample.flat_region;
      if (region.radius <= 0) continue;
      const Eigen::Vector3d first = region.normal.unitOrthogonal();
      const Eigen::Vector3d second = region.normal.cross(first);
      for (int i = 0; i < 8; ++i) {
        CHECK(is_boundary(sample.closest +
                          region.radius * (std::cos(i) * first + std::sin(i) * second)));
      }
    }
  }
}

TEST_CASE("a warm start, a known side and other threads change nothing") {
  const BrepDistanceField field(reread(OcctSolid::vase()));
  const std::vector<Eigen::Vector3d> points = sample_points(field, 100);
  std::vector<DistanceSample> alone;
  for (const Eigen::Vector3d& point : points) alone.push_back(field.measure({.point = point}));
  const auto check = [&](bool& is_same) {
    std::vector<DistanceQuery> queries;
    for (std::size_t i = 0; i < points.size(); ++i) {
      queries.push_back({.point = points[i],
                         .side = alone[i].distance > 0 ? Side::inside : Side::outside,
                         .bound = std::abs(alone[i].distance) * (1 + 1e-12)});
    }
    std::vector<DistanceSample> samples(points.size());
    field.measure(queries, samples);
    is_same = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
      is_same &= std::abs(samples[i].distance - alone[i].distance) < 1e-12;
    }
  };
  bool is_same[2] = {false, false};
  std::thread other(check, std::ref(is_same[0]));
  check(is_same[1]);
  other.join();
  CHECK(is_same[0]);
  CHECK(is_same[1]);
}

TEST_CASE("the enclosing ball is that of the exact surface") {
  const auto radius = [](const OcctSolid& solid) {
    return BrepDistanceField(reread(solid)).enclosing_ball().radius;
  };
  CHECK(radius(OcctSolid::sphere(1.0)) == Approx(1.0).epsilon(1e-12));
  CHECK(radius(OcctSolid::torus(2.0, 0.5)) == Approx(2.5).epsilon(1e-11));
  CHECK(radius(OcctSolid::torus(2.0, 0.5).as_splines()) == Approx(2.5).epsilon(1e-11));
  CHECK(radius(OcctSolid::cylinder(1.0, 3.0)) == Approx(std::hypot(1.0, 1.5)).epsilon(1e-12));
  // The ball touches the eight spheres at the corners.
  const OcctSolid block = OcctSolid::box({-1, -1, -1}, {1, 1, 1});
  CHECK(radius(block.with_fillets(0.3)) == Approx(0.7 * std::sqrt(3.0) + 0.3).epsilon(1e-11));
}
