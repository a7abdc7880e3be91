#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "features/decomposition/certificate.h"
#include "features/decomposition/decompose.h"
#include "features/distance/planar_distance_field.h"

using namespace mdbd;

namespace {

PlanarDomain transformed(PlanarDomain domain, const Eigen::Affine2d& motion) {
  for (Outline& outline : domain) {
    for (Eigen::Vector2d& point : outline) point = motion * point;
  }
  return simplify(domain);
}

PlanarDomain rotated(const PlanarDomain& domain, double angle) {
  Eigen::Affine2d motion = Eigen::Affine2d::Identity();
  motion.translate(Eigen::Vector2d(3.0, -2.0)).rotate(angle);
  return transformed(domain, motion);
}

// Equilateral, with an incircle of radius 1.
PlanarDomain make_triangle() {
  Outline outline;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * std::numbers::pi * i / 3;
    outline.emplace_back(2 * std::cos(angle), 2 * std::sin(angle));
  }
  return {outline};
}

PlanarDomain make_rectangle(double width, double height) {
  return {{{0, 0}, {width, 0}, {width, height}, {0, height}}};
}

BallDecomposition decompose_domain(const PlanarDomain& domain, int balls) {
  return decompose(PlanarDistanceField(domain), {.balls = balls});
}

double segment_distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

bool is_inside(const PlanarDomain& domain, const Eigen::Vector2d& p) {
  bool inside = false;
  for (const Outline& outline : domain) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Eigen::Vector2d& a = outline[i];
      const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (p.x() < x) inside = !inside;
    }
  }
  return inside;
}

double brute_force_distance(const PlanarDomain& domain, const Eigen::Vector2d& p) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Outline& outline : domain) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      distance =
          std::min(distance, segment_distance(p, outline[i], outline[(i + 1) % outline.size()]));
    }
  }
  return is_inside(domain, p) ? distance : -distance;
}

// A square with a round hole of 40 sides, off the centre.
PlanarDomain make_plate_with_hole() {
  PlanarDomain domain = make_rectangle(4.0, 3.0);
  Outline hole;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    hole.emplace_back(1.3 + 0.7 * std::cos(angle), 1.6 + 0.7 * std::sin(angle));
  }
  domain.push_back(hole);
  return simplify(domain);
}

}  // namespace

TEST_CASE("the distances of a domain are those of its sides") {
  const PlanarDomain domain = rotated(make_plate_with_hole(), 0.7);
  const PlanarDistanceField field(domain);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-6.0, 6.0);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d point(coordinate(random), coordinate(random));
    const DistanceSample sample = field.measure({.point = {point.x(), point.y(), 0.0}});
    const double expected = brute_force_distance(domain, point);
    CHECK(sample.distance == Approx(expected).margin(1e-12));
    CHECK(sample.closest.z() == 0.0);
    CHECK((sample.closest.head<2>() - point).norm() == Approx(std::abs(expected)).margin(1e-12));
  }
}

// By Descartes' theorem a disc that touches two touching discs of curvatures a and b, and a line
// that both touch, has the curvature a + b + 2 sqrt(ab).
TEST_CASE("the discs of an equilateral triangle follow Descartes' theorem") {
  const auto between = [](double a, double b) { return a + b + 2 * std::sqrt(a * b); };
  const double second = between(1, 3);
  std::vector<double> curvatures = {1};
  curvatures.insert(curvatures.end(), 3, 3);
  curvatures.insert(curvatures.end(), 6, second);
  curvatures.insert(curvatures.end(), 3, 9);
  curvatures.insert(curvatures.end(), 6, between(1, second));
  for (int turn = 0; turn < 20; ++turn) {
    const BallDecomposition result = decompose_domain(rotated(make_triangle(), 0.37 * turn),
                                                      static_cast<int>(curvatures.size()));
    REQUIRE(result.balls.size() == curvatures.size());
    for (std::size_t i = 0; i < curvatures.size(); ++i) {
      CHECK(result.balls[i].radius == Approx(1 / curvatures[i]).margin(1e-6));
      CHECK(result.balls[i].center.z() == 0.0);
    }
  }
}

// Figures 3 and 4 of the paper: of infinitely many largest discs those at the branch points of the
// medial axis are chosen, since they leave the most room.
TEST_CASE("a rectangle has its first discs at the ends, however it lies") {
  for (int turn = 0; turn < 20; ++turn) {
    const BallDecomposition result =
        decompose_domain(rotated(make_rectangle(2.5, 1.0), 0.31 * turn), 2);
    REQUIRE(result.balls.size() == 2);
    CHECK(result.balls[0].radius == Approx(0.5).margin(1e-6));
    CHECK(result.balls[1].radius == Approx(0.5).margin(1e-6));
    const double apart = (result.balls[0].center - result.balls[1].center).norm();
    CHECK(apart == Approx(1.5).margin(1e-5));
  }
}

// Figure 5: a small notch at one end decides between decompositions that were equal before.
TEST_CASE("a notch favours one of two isomorphic decompositions") {
  const PlanarDomain notched = {
      {{0, 0}, {1.2, 0}, {1.25, 0.05}, {1.3, 0}, {2.5, 0}, {2.5, 1}, {0, 1}}};
  const BallDecomposition expected = decompose_domain(simplify(notched), 10);
  for (int turn = 1; turn < 10; ++turn) {
    const BallDecomposition result = decompose_domain(rotated(notched, 0.5 * turn), 10);
    REQUIRE(result.balls.size() == expected.balls.size());
    for (std::size_t i = 0; i < expected.balls.size(); ++i) {
      CHECK(result.balls[i].radius == Approx(expected.balls[i].radius).margin(1e-6));
    }
  }
}

// Figure 6: the largest disc of a square sees nothing of a small feature; later ones do.
TEST_CASE("a small feature of a square is met by later discs") {
  const PlanarDomain square = make_rectangle(2.0, 2.0);
  const PlanarDomain featured = {
      {{0, 0}, {2, 0}, {2, 2}, {1.95, 2}, {1.9, 2.1}, {1.85, 2}, {0, 2}}};
  const auto plain = decompose_domain(simplify(square), 100).balls;
  const auto changed = decompose_domain(simplify(featured), 100).balls;
  CHECK(plain[0].radius == Approx(1.0).margin(1e-6));
  CHECK(changed[0].radius == Approx(1.0).margin(1e-6));
  const auto is_in_feature = [](const Ball& ball) { return ball.center.y() > 2.0; };
  CHECK(std::ranges::none_of(plain, is_in_feature));
  CHECK(std::ranges::any_of(changed, is_in_feature));
}

TEST_CASE("the discs of a domain are contained, disjoint and maximal") {
  const PlanarDomain domain = make_plate_with_hole();
  const PlanarDistanceField field(domain);
  const BallDecomposition result = decompose(field, {.balls = 100});
  REQUIRE(result.balls.size() == 100);
  const Certificate certificate = check_certificate(field, result);
  CHECK(certificate.containment_violation <= 1e-12);
  CHECK(certificate.overlap_violation <= 1e-12);
  CHECK(certificate.maximality_gap <= 1e-3);
  CHECK(result.is_certified);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(0.0, 4.0);
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector2d point(coordinate(random), coordinate(random));
    double room = brute_force_distance(domain, point);
    for (std::size_t j = 0; j < result.balls.size(); ++j) {
      REQUIRE(room <= result.upper_bounds[j] * (1 + 1e-9));
      const double from_disc = (result.balls[j].center.head<2>() - point).norm();
      room = std::min(room, from_disc - result.balls[j].radius);
    }
  }
}
