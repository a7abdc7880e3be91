// Distances of CSG solids against closed forms, a mesh, and brute force.
#include "features/implicit/csg_distance_field.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "features/distance/mesh_distance_field.h"
#include "tests/implicit/solids.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/brute_force.h"

namespace mdbd::test {
namespace {

using Eigen::Vector3d;
using SignedDistance = std::function<double(const Vector3d&)>;

double distance_at(const DistanceField& field, const Vector3d& x) {
  return field.measure({.point = x}).distance;
}

/// The largest difference of a field and another at random points.
double largest_difference(const DistanceField& field, const SignedDistance& expected, double size) {
  std::mt19937 random(1);
  double largest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d x = random_point(random, size);
    largest = std::max(largest, std::abs(distance_at(field, x) - expected(x)));
  }
  return largest;
}

SignedDistance of(const DistanceField& field) {
  return [&field](const Vector3d& x) { return distance_at(field, x); };
}

/// Of the ball of radius 1 without the one of radius 0.7 around (0.8, 0, 0): the feet on both, as
/// far as they are boundary, and the circle where they meet.
double moon_distance(const Vector3d& x) {
  const Vector3d other(0.8, 0, 0);
  const double across = std::hypot(x.y(), x.z());
  const double rim_x = (1.0 - 0.49 + 0.64) / 1.6;
  double distance = std::hypot(x.x() - rim_x, across - std::sqrt(1.0 - rim_x * rim_x));
  if ((x.normalized() - other).norm() > 0.7) distance = std::min(distance, std::abs(x.norm() - 1));
  const double away = (x - other).norm();
  if ((other + 0.7 * (x - other) / away).norm() < 1.0) {
    distance = std::min(distance, std::abs(away - 0.7));
  }
  return x.norm() < 1 && away > 0.7 ? distance : -distance;
}

double cylinder_distance(const Vector3d& x, double radius, double half) {
  const double outside = std::hypot(x.x(), x.y()) - radius;
  const double above = std::abs(x.z()) - half;
  if (outside < 0 && above < 0) return std::min(-outside, -above);
  return -std::hypot(std::max(outside, 0.0), std::max(above, 0.0));
}

TriangleMesh l_mesh() {
  const std::array<std::array<double, 2>, 6> outline = {
      {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : outline) mesh.vertices.emplace_back(x, y, z);
  }
  for (const auto& [a, b, c] : {Triangle{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    mesh.triangles.push_back({c, b, a});
    mesh.triangles.push_back({a + 6, b + 6, c + 6});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, j + 6});
    mesh.triangles.push_back({i, j + 6, i + 6});
  }
  return mesh;
}

/// A solid of random primitives, and random points of their surfaces, for brute force.
struct RandomSolid {
  std::string document;
  std::vector<Vector3d> surface_points;
};

class SolidMaker {
 public:
  explicit SolidMaker(std::uint32_t seed) : random_(seed) {}

  RandomSolid make(int samples) {
    RandomSolid solid;
    samples_ = samples;
    solid.document = operation("union", operation("intersection", primitive(), primitive()),
                               operation("difference", primitive(), primitive()));
    if (random_() % 2 == 0) solid.document = operation("difference", solid.document, primitive());
    solid.surface_points = std::move(points_);
    return solid;
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector3d direction() { return random_rotation(random_) * Vector3d::UnitX(); }
  static std::string text(const Vector3d& v) {
    return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
  }
  static std::string operation(const char* name, const std::string& a, const std::string& b) {
    return fmt::format(R"({{"{}": [{}, {}]}})", name, a, b);
  }

  std::string primitive() {
    const Vector3d center = random_point(random_, 0.5);
    switch (random_() % 4) {
      case 0:
        return sphere(center, uniform(0.5, 1.0));
      case 1:
        return box(center, Vector3d(uniform(0.4, 1), uniform(0.4, 1), uniform(0.4, 1)));
      case 2:
        return cylinder(center, uniform(0.3, 0.7), uniform(0.6, 1.2));
      default:
        return torus(center, uniform(0.6, 0.9), uniform(0.15, 0.4));
    }
  }

  std::string sphere(const Vector3d& center, double radius) {
    for (int i = 0; i < samples_; ++i) points_.push_back(center + radius * direction());
    return fmt::format(R"({{"sphere": {{"center": {}, "radius": {}}}}})", text(center), radius);
  }

  std::string box(const Vector3d& center, const Vector3d& half) {
    const double angle = uniform(0, 90);
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(angle * std::numbers::pi / 180, Vector3d::UnitZ()).toRotationMatrix();
    for (int i = 0; i < samples_; ++i) {
      Vector3d point = random_point(random_, 1.0);
      point[i % 3] = i % 6 < 3 ? 1.0 : -1.0;
      points_.push_back(center + rotation * point.cwiseProduct(half));
    }
    return fmt::format(
        R"({{"translate": {}, "of": {{"rotate": {{"axis": [0, 0, 1], "degrees": {}}}, "of":
            {{"box": {{"min": {}, "max": {}}}}}}}}})",
        text(center), angle, text(-half), text(half));
  }

  std::string cylinder(const Vector3d& center, double radius, double half) {
    const Vector3d axis = direction();
    const Vector3d u = axis.unitOrthogonal();
    const Vector3d v = axis.cross(u);
    for (int i = 0; i < samples_; ++i) {
      const double angle = uniform(0, 2 * std::numbers::pi);
      const bool is_side = i % 2 == 0;
      const double away = is_side ? radius : radius * std::sqrt(uniform(0, 1));
      const double along = is_side ? uniform(-half, half) : i % 4 == 1 ? half : -half;
      points_.push_back(center + along * axis + away * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return fmt::format(R"({{"cylinder": {{"from": {}, "to": {}, "radius": {}}}}})",
                       text(center - half * axis), text(center + half * axis), radius);
  }

  std::string torus(const Vector3d& center, double radius, double tube) {
    const Vector3d axis = direction();
    const Vector3d u = axis.unitOrthogonal();
    const Vector3d v = axis.cross(u);
    for (int i = 0; i < samples_; ++i) {
      const double a = uniform(0, 2 * std::numbers::pi);
      const double b = uniform(0, 2 * std::numbers::pi);
      const Vector3d outward = std::cos(a) * u + std::sin(a) * v;
      points_.push_back(center + (radius + tube * std::cos(b)) * outward +
                        tube * std::sin(b) * axis);
    }
    return fmt::format(
        R"({{"torus": {{"center": {}, "axis": {}, "radius": {}, "tube_radius": {}}}}})",
        text(center), text(axis), radius, tube);
  }

  std::mt19937 random_;
  int samples_ = 0;
  std::vector<Vector3d> points_;
};

/// Whether random points around a point are inside and outside.
bool has_both_sides(const CsgSolid& solid, const Vector3d& x) {
  std::mt19937 random(1);
  std::vector<double> distances;
  bool has_inside = false;
  bool has_outside = false;
  for (int i = 0; i < 3000 && !(has_inside && has_outside); ++i) {
    solid.measure_surfaces(x + random_point(random, 1e-6), distances);
    (solid.value(distances) > 0 ? has_inside : has_outside) = true;
  }
  return has_inside && has_outside;
}

}  // namespace

TEST_CASE("Primitives have their closed-form distances") {
  const CsgDistanceField ball = csg_field(R"({"sphere": {"radius": 1}})");
  CHECK(largest_difference(ball, of(UnitBallField()), 2) < 1e-12);
  const CsgDistanceField box =
      csg_field(R"({"box": {"min": [-1.25, -0.5, -0.5], "max": [1.25, 0.5, 0.5]}})");
  CHECK(largest_difference(box, of(BoxField({1.25, 0.5, 0.5})), 2) < 1e-10);
  const CsgDistanceField torus = csg_field(R"({"torus": {"radius": 2, "tube_radius": 0.5}})");
  CHECK(largest_difference(torus, of(TorusField(2, 0.5)), 3) < 1e-12);
  const CsgDistanceField cylinder =
      csg_field(R"({"cylinder": {"from": [0, 0, -1], "to": [0, 0, 1], "radius": 0.7}})");
  CHECK(largest_difference(
            cylinder, [](const Vector3d& x) { return cylinder_distance(x, 0.7, 1); }, 2) < 1e-10);
}

TEST_CASE("Solids of several primitives have their closed-form distances") {
  CHECK(largest_difference(csg_field(moon), moon_distance, 2) < 1e-10);

  // The hole goes all the way through; its rim is nearest for some points outside only.
  const CsgDistanceField block = csg_field(bored_block);
  std::mt19937 random(3);
  const BoxField box({2, 1, 1});
  double largest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d x = random_point(random, 1.0);
    const double from_axis = std::hypot(x.x(), x.y());
    if (from_axis < 0.5) continue;
    const double expected = std::min(from_axis - 0.5, distance_at(box, x));
    largest = std::max(largest, std::abs(distance_at(block, x) - expected));
  }
  CHECK(largest < 1e-10);

  const auto capsule_distance = [](const Vector3d& x) {
    return 0.5 - (x - Vector3d(0, 0, std::clamp(x.z(), -1.0, 1.0))).norm();
  };
  CHECK(largest_difference(csg_field(capsule), capsule_distance, 2) < 1e-10);

  // Two equal cylinders: inside, the nearer of both; the curves where they meet cross twice.
  const CsgDistanceField crossed = csg_field(crossed_cylinders);
  largest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d x = random_point(random, 1.0);
    const double first = 1.0 - std::hypot(x.y(), x.z());
    const double second = 1.0 - std::hypot(x.x(), x.z());
    if (first < 0 || second < 0) continue;
    largest = std::max(largest, std::abs(distance_at(crossed, x) - std::min(first, second)));
  }
  CHECK(largest < 1e-10);
}

TEST_CASE("Parts that touch are one solid") {
  // Of the wall between the boxes nothing is left: distances are those of the mesh of the whole.
  const MeshDistanceField mesh(l_mesh(), true);
  CHECK(largest_difference(csg_field(l_shape), of(mesh), 4) < 1e-10);
  // Nor of the face that a difference leaves without thickness.
  const CsgDistanceField cut = csg_field(
      R"({"difference": [{"box": {"min": [-1, -1, -1], "max": [1, 1, 1]}},
                         {"box": {"min": [0, -1, -1], "max": [1, 1, 1]}}]})");
  const CsgDistanceField half = csg_field(R"({"box": {"min": [-1, -1, -1], "max": [0, 1, 1]}})");
  CHECK(largest_difference(cut, of(half), 2) < 1e-10);
}

TEST_CASE("No point of the boundary is nearer than the distance") {
  std::mt19937 random(11);
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    const RandomSolid solid = SolidMaker(seed).make(3000);
    INFO(seed << ": " << solid.document);
    const CsgSolid csg = csg_solid(solid.document);
    std::vector<Vector3d> boundary;
    for (const Vector3d& point : solid.surface_points) {
      if (csg.is_boundary(point, 1e-11)) boundary.push_back(point);
    }
    REQUIRE(boundary.size() > 500);
    const CsgDistanceField field(csg);
    double worst = 0.0;
    double farthest_closest = 0.0;
    for (int i = 0; i < 100; ++i) {
      const Vector3d x = random_point(random, 1.5);
      const DistanceSample sample = field.measure({.point = x});
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vector3d& point : boundary) nearest = std::min(nearest, (point - x).norm());
      const double distance = std::abs(sample.distance);
      worst = std::max(worst, distance - nearest);
      const double off = std::abs((sample.closest - x).norm() - distance);
      farthest_closest = std::max(farthest_closest, off);
      CHECK(has_both_sides(csg, sample.closest));
    }
    CHECK(worst < 1e-9);
    CHECK(farthest_closest < 1e-9);
  }
}

TEST_CASE("Distances are 1-Lipschitz") {
  std::mt19937 random(5);
  for (const std::string& document : {l_shape, bored_block, moon, crossed_cylinders, capsule}) {
    const CsgDistanceField field = csg_field(document);
    double worst = 0.0;
    for (int i = 0; i < 3000; ++i) {
      const Vector3d x = random_point(random, 2.5);
      const Vector3d y = x + random_point(random, i % 2 == 0 ? 0.01 : 1.0);
      const double change = std::abs(distance_at(field, x) - distance_at(field, y));
      worst = std::max(worst, change - (x - y).norm());
    }
    INFO(document);
    CHECK(worst < 1e-9);
  }
}

TEST_CASE("Enclosing balls are the smallest") {
  const auto ball_of = [](const std::string& solid) { return csg_field(solid).enclosing_ball(); };
  const auto check = [](const Ball& ball, const Vector3d& center, double radius) {
    CHECK(ball.radius == Approx(radius).epsilon(1e-10));
    CHECK((ball.center - center).norm() < 1e-5 * radius);
  };
  check(ball_of(R"({"sphere": {"center": [5, 6, 7], "radius": 3}})"), {5, 6, 7}, 3);
  check(ball_of(R"({"box": {"min": [0, 0, 0], "max": [2, 4, 4]}})"), {1, 2, 2}, 3);
  check(ball_of(R"({"torus": {"axis": [1, 2, 3], "radius": 2, "tube_radius": 0.5}})"), {0, 0, 0},
        2.5);
  check(ball_of(R"({"cylinder": {"from": [0, 0, 0], "to": [8, 0, 0], "radius": 3}})"), {4, 0, 0},
        5);
  check(ball_of(capsule), {0, 0, 0}, 1.5);
  check(ball_of(moon), {0, 0, 0}, 1.0);
  // Half a ball, cut askew.
  check(ball_of(R"({"intersection": [{"sphere": {"radius": 2}},
                    {"halfspace": {"point": [0, 0, 0], "outward": [1, 2, 3]}}]})"),
        {0, 0, 0}, 2.0);
  // A cap of a ball: its rim is a great circle of the smallest ball.
  check(ball_of(R"({"intersection": [{"sphere": {"radius": 5}},
                    {"halfspace": {"point": [0, 0, 4], "outward": [0, 0, -1]}}]})"),
        {0, 0, 4}, 3.0);
  check(ball_of(l_shape), {1.5, 1.5, 0.5}, std::sqrt(4.75));
}

TEST_CASE("Distances move, turn and scale with the solid") {
  std::mt19937 random(9);
  for (const std::string& document : {l_shape, bored_block, moon, crossed_cylinders, capsule}) {
    const CsgDistanceField plain = csg_field(document);
    const CsgDistanceField moved = csg_field(
        R"({"translate": [10, -20, 30], "of": {"rotate": {"axis": [1, 2, 3], "degrees": 50}, "of":
            {"scale": 3, "of": )" +
        document + "}}}");
    const Eigen::AngleAxisd rotation(50 * std::numbers::pi / 180, Vector3d(1, 2, 3).normalized());
    double worst = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const Vector3d x = random_point(random, 2.5);
      const Vector3d y = rotation * (3.0 * x) + Vector3d(10, -20, 30);
      worst = std::max(worst, std::abs(3.0 * distance_at(plain, x) - distance_at(moved, y)));
    }
    INFO(document);
    CHECK(worst < 1e-9);
    CHECK(moved.enclosing_ball().radius ==
          Approx(3.0 * plain.enclosing_ball().radius).epsilon(1e-9));
  }
}

TEST_CASE("Empty and unbounded solids are refused") {
  const auto refusing = [](const std::string& solid) { csg_field(solid); };
  const std::string half_space = R"({"halfspace": {"point": [0, 0, 0], "outward": [0, 0, 1]}})";
  CHECK_THROWS_WITH(refusing(half_space), Catch::Contains("not known to be bounded"));
  CHECK_THROWS_WITH(refusing(R"({"union": [{"sphere": {"radius": 1}}, )" + half_space + "]}"),
                    Catch::Contains("not known to be bounded"));
  CHECK_THROWS_WITH(refusing(R"({"intersection": [{"sphere": {"radius": 1}},
                        {"sphere": {"center": [5, 0, 0], "radius": 1}}]})"),
                    Catch::Contains("empty"));
  // Boxes that overlap hide that the spheres do not.
  CHECK_THROWS_WITH(refusing(R"({"intersection": [{"sphere": {"radius": 1}},
                        {"sphere": {"center": [1.3, 1.3, 1.3], "radius": 1}}]})"),
                    Catch::Contains("empty"));
  CHECK_THROWS_WITH(refusing(R"({"difference": [{"sphere": {"radius": 1}},
                        {"sphere": {"radius": 2}}]})"),
                    Catch::Contains("empty"));
}

}  // namespace mdbd::test
