#include "features/decomposition/decompose.h"

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/core/tolerances.h"
#include "features/decomposition/certificate.h"
#include "features/distance/mesh_distance_field.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

// A prism over an equilateral triangle whose incircle has radius 1, two units high: one ball of
// radius 1 touches all five faces.
TriangleMesh make_triangular_prism() {
  TriangleMesh mesh;
  for (const double z : {-1.0, 1.0}) {
    for (int i = 0; i < 3; ++i) {
      const double angle = 2 * std::numbers::pi * i / 3;
      mesh.vertices.emplace_back(2 * std::cos(angle), 2 * std::sin(angle), z);
    }
  }
  mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                    {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return mesh;
}

TriangleMesh make_box(const Eigen::Vector3d& size) {
  TriangleMesh mesh = make_cube();
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = vertex.cwiseProduct(size);
  return mesh;
}

TriangleMesh transformed(TriangleMesh mesh, const Eigen::Affine3d& motion) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = motion * vertex;
  return mesh;
}

// Checks the three promises with distances that share no code with the product: every ball is
// inside and clear of the others, and at no sample does a ball larger than promised fit.
void check_promises(const TriangleMesh& mesh, const BallDecomposition& result, double tolerance) {
  const double slack = tolerances::containment * result.scale;
  const auto distance = [&](const Eigen::Vector3d& x) {
    const double sign = mesh_winding(mesh, x) > 0.5 ? 1.0 : -1.0;
    return sign * mesh_distance(mesh, x);
  };
  REQUIRE(result.upper_bounds.size() == result.balls.size());
  std::mt19937 random(7);
  std::vector<std::pair<Eigen::Vector3d, double>> samples;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d point = mesh.vertices[0] + random_point(random, 2 * result.scale);
    samples.emplace_back(point, distance(point));
  }
  for (const Ball& ball : result.balls) {  // where the next balls go is where a rival would be
    const Eigen::Vector3d point = ball.center + random_point(random, 0.1 * ball.radius);
    samples.emplace_back(point, distance(point));
  }
  for (std::size_t i = 0; i < result.balls.size(); ++i) {
    const Ball& ball = result.balls[i];
    const std::span<const Ball> earlier(result.balls.data(), i);
    CHECK(ball.radius > 0);
    CHECK(ball.radius <= distance(ball.center) + slack);
    CHECK(ball.radius <= ball_distance(earlier, ball.center) + slack);
    CHECK(result.upper_bounds[i] <= ball.radius * (1 + tolerance));
    for (const auto& [point, value] : samples) {
      REQUIRE(std::min(value, ball_distance(earlier, point)) <= result.upper_bounds[i] + slack);
    }
  }
}

std::vector<double> radii(const BallDecomposition& result) {
  std::vector<double> list;
  for (const Ball& ball : result.balls) list.push_back(ball.radius);
  return list;
}

}  // namespace

TEST_CASE("the unit cube: 0.5, eight of 0.133975, then 24 of 0.09335") {
  const BallDecomposition result = decompose(MeshDistanceField(make_cube(), true), {.balls = 33});
  REQUIRE(result.balls.size() == 33);
  CHECK(result.balls[0].radius == Approx(0.5).epsilon(1e-9));
  const double corner = (std::sqrt(3.0) - 1) / (2 * (std::sqrt(3.0) + 1));
  for (int i = 1; i <= 8; ++i) CHECK(result.balls[i].radius == Approx(corner).epsilon(1e-9));
  for (int i = 9; i < 33; ++i) CHECK(result.balls[i].radius == Approx(0.09335).epsilon(1e-4));
  CHECK(result.scale == Approx(0.5 * std::sqrt(3.0)));
  CHECK(result.termination == Termination::ball_count);
}

TEST_CASE("a ball holds one ball and then nothing") {
  const BallDecomposition result = decompose(UnitBallField(), {.balls = 10});
  REQUIRE(result.balls.size() == 1);
  CHECK(result.balls[0].radius == Approx(1.0).epsilon(1e-9));
  CHECK(result.termination == Termination::minimum_radius);
}

namespace {

/// A cube of side 2 that takes points outside its enclosing ball for points inside.
class ErringField final : public DistanceField {
 public:
  using DistanceField::measure;
  bool is_closed() const override { return true; }
  Ball enclosing_ball() const override { return cube_.enclosing_ball(); }
  void measure(std::span<const DistanceQuery> queries,
               std::span<DistanceSample> samples) const override {
    cube_.measure(queries, samples);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const bool errs = queries[i].side == Side::unknown &&
                        queries[i].point.norm() > cube_.enclosing_ball().radius;
      if (errs) samples[i].distance = std::abs(samples[i].distance);
    }
  }

 private:
  BoxField cube_{Eigen::Vector3d::Ones()};
};

}  // namespace

TEST_CASE("a field that errs far away leads no ball out of the enclosing ball") {
  const BallDecomposition result = decompose(ErringField(), {.balls = 9});
  REQUIRE(result.balls.size() == 9);
  CHECK(result.balls[0].radius == Approx(1.0));
  CHECK(result.balls[8].radius == Approx(0.26795).epsilon(1e-3));  // 2 x 0.133975
}

TEST_CASE("an equilateral prism: its inscribed ball, then six in the corners") {
  const BallDecomposition result =
      decompose(MeshDistanceField(make_triangular_prism(), true), {.balls = 7});
  REQUIRE(result.balls.size() == 7);
  CHECK(result.balls[0].radius == Approx(1.0).epsilon(1e-9));
  const double corner = (std::sqrt(5.0) - 1) / (std::sqrt(5.0) + 1);
  for (int i = 1; i < 7; ++i) CHECK(result.balls[i].radius == Approx(corner).epsilon(1e-9));
}

TEST_CASE("the first balls of boxes and tori have half the thickness") {
  CHECK(decompose(BoxField({1.0, 0.6, 0.2}), {.balls = 1}).balls[0].radius == Approx(0.2));
  CHECK(decompose(TorusField(1.0, 0.25), {.balls = 1}).balls[0].radius == Approx(0.25));
  const BallDecomposition ring = decompose(TorusField(1.0, 0.25), {.balls = 5});
  for (const Ball& ball : ring.balls) CHECK(ball.radius == Approx(0.25).epsilon(1e-3));
}

TEST_CASE("every promise holds by brute force") {
  const double tolerance = GENERATE(1e-1, 1e-2, 1e-3);
  TriangleMesh mesh;
  SECTION("cube") { mesh = make_cube(); }
  SECTION("prism") { mesh = make_triangular_prism(); }
  SECTION("plate") { mesh = make_box({1.0, 0.7, 0.1}); }
  SECTION("torus") { mesh = make_torus(1.0, 0.4, 24, 12); }
  const BallDecomposition result =
      decompose(MeshDistanceField(mesh, true), {.balls = 60, .radius_tolerance = tolerance});
  CHECK(result.balls.size() == 60);
  check_promises(mesh, result, tolerance);
}

TEST_CASE("a tolerance below the usual weight of the place holds where balls can slide") {
  const double tolerance = GENERATE(1e-4, 1e-5, 1e-6);
  const BallDecomposition result = decompose(MeshDistanceField(make_box({2.0, 0.3, 0.3}), true),
                                             {.balls = 10, .radius_tolerance = tolerance});
  REQUIRE(result.balls.size() == 10);
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(result.balls[i].radius <= result.upper_bounds[i]);
    CHECK(result.upper_bounds[i] <= result.balls[i].radius * (1 + tolerance));
  }
  for (std::size_t i = 0; i < 6; ++i) CHECK(result.balls[i].radius >= 0.15 / (1 + tolerance));
}

TEST_CASE("the certificate of a decomposition is clean, and a spoiled one is found out") {
  const MeshDistanceField field(make_torus(1.0, 0.4, 24, 12), true);
  BallDecomposition result = decompose(field, {.balls = 50});
  const Certificate certificate = check_certificate(field, result);
  CHECK(certificate.containment_violation <= tolerances::containment);
  CHECK(certificate.overlap_violation <= tolerances::containment);
  CHECK(certificate.maximality_gap <= 1e-3);
  result.balls[3].radius *= 1.01;
  const Certificate spoiled = check_certificate(field, result);
  CHECK(spoiled.containment_violation > 1e-4);
  CHECK(spoiled.overlap_violation > 1e-4);
}

TEST_CASE("two runs give the same bits") {
  const MeshDistanceField field(make_torus(1.0, 0.4, 24, 12), true);
  const BallDecomposition first = decompose(field, {.balls = 80});
  const BallDecomposition second = decompose(field, {.balls = 80});
  REQUIRE(first.balls.size() == second.balls.size());
  for (std::size_t i = 0; i < first.balls.size(); ++i) {
    CHECK(first.balls[i].center == second.balls[i].center);
    CHECK(first.balls[i].radius == second.balls[i].radius);
    CHECK(first.upper_bounds[i] == second.upper_bounds[i]);
  }
  CHECK(first.cost.distance_queries == second.cost.distance_queries);
}

TEST_CASE("more balls continue the same list") {
  const MeshDistanceField field(make_triangular_prism(), true);
  const std::vector<double> few = radii(decompose(field, {.balls = 20}));
  std::vector<double> many = radii(decompose(field, {.balls = 40}));
  many.resize(few.size());
  CHECK(few == many);
}

TEST_CASE("motion, reflection and scale leave the radii of a shape with isolated maxima") {
  const TriangleMesh mesh = make_triangular_prism();
  const std::vector<double> expected =
      radii(decompose(MeshDistanceField(mesh, true), {.balls = 7}));
  std::mt19937 random(5);
  for (int round = 0; round < 5; ++round) {
    const double scale = std::pow(10.0, round - 2);
    Eigen::Affine3d motion = Eigen::Affine3d::Identity();
    motion.translate(scale * random_point(random, 10.0));
    motion.rotate(random_rotation(random));
    motion.scale(scale);
    TriangleMesh moved = transformed(mesh, motion);
    if (round % 2 == 1) {
      moved = transformed(moved, Eigen::Affine3d(Eigen::Scaling(-1.0, 1.0, 1.0)));
      for (Triangle& triangle : moved.triangles) std::swap(triangle[0], triangle[1]);
    }
    const std::vector<double> found =
        radii(decompose(MeshDistanceField(moved, true), {.balls = 7}));
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i] / scale == Approx(expected[i]).epsilon(1e-8));
    }
  }
}

TEST_CASE("surfaces that enclose nothing have an empty interior") {
  TriangleMesh mesh;
  SECTION("one triangle") {
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
  }
  SECTION("an open square") {
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  }
  SECTION("a square folded onto itself") {
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}};
  }
  const BallDecomposition result = decompose(MeshDistanceField(mesh, false));
  CHECK(result.balls.empty());
  CHECK(result.termination == Termination::empty_interior);
}

TEST_CASE("open shapes are decomposed without a proof, and end") {
  TriangleMesh open = make_cube();
  open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);
  std::mt19937 random(6);
  for (int round = 0; round < 6; ++round) {
    Eigen::Affine3d motion(random_rotation(random));
    motion.scale(Eigen::Vector3d(1.3, 1.0, 0.3 + 0.2 * round));
    const TriangleMesh mesh = transformed(open, motion);
    const BallDecomposition result = decompose(MeshDistanceField(mesh, false), {.balls = 20});
    CHECK_FALSE(result.is_certified);
    CHECK(result.balls.size() == 20);
    for (std::size_t i = 0; i < result.balls.size(); ++i) {
      const Ball& ball = result.balls[i];
      const std::span<const Ball> earlier(result.balls.data(), i);
      CHECK(ball.radius > 0);
      CHECK(ball.radius <= mesh_distance(mesh, ball.center) + 1e-9);
      CHECK(ball.radius <= ball_distance(earlier, ball.center) + 1e-9);
      CHECK(mesh_winding(mesh, ball.center) > 0.4);
    }
  }
}

TEST_CASE("no ball is smaller than the minimum radius") {
  const BallDecomposition result =
      decompose(MeshDistanceField(make_cube(), true), {.balls = 1000, .minimum_radius = 0.1});
  CHECK(result.termination == Termination::minimum_radius);
  CHECK(result.balls.size() == 33);
  CHECK(result.balls.back().radius > 0.1 * result.scale);
}

TEST_CASE("memory is bounded, and what could not be proved for it is said") {
  // A shell of thickness 0.04 around the unit ball would take far more cells.
  TriangleMesh shell = make_sphere(1.0, 24);
  TriangleMesh cavity = make_sphere(0.96, 24);
  const auto first = static_cast<std::uint32_t>(shell.vertices.size());
  shell.vertices.insert(shell.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
  for (const auto& [a, b, c] : cavity.triangles) {
    shell.triangles.push_back({c + first, b + first, a + first});
  }
  const BallDecomposition result =
      decompose(MeshDistanceField(shell, true), {.balls = 30, .most_cells = 4000});
  CHECK(result.balls.size() == 30);
  CHECK_FALSE(result.is_certified);
  check_promises(shell, result, 5.0);
  CHECK(decompose(MeshDistanceField(make_cube(), true), {.balls = 33, .most_cells = 4000})
            .is_certified);
}

TEST_CASE("options out of range are refused") {
  const UnitBallField field;
  CHECK_THROWS_AS(decompose(field, {.balls = 0}), InvalidInput);
  CHECK_THROWS_AS(decompose(field, {.radius_tolerance = 0.0}), InvalidInput);
  CHECK_THROWS_AS(decompose(field, {.minimum_radius = -1.0}), InvalidInput);
  CHECK_THROWS_AS(decompose(field, {.most_cells = 0}), InvalidInput);
  CHECK_THROWS_AS(decompose(field, {.radius_tolerance = std::nan("")}), InvalidInput);
}
