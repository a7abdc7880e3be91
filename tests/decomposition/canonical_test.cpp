#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "features/decomposition/decompose.h"
#include "features/distance/mesh_distance_field.h"
#include "features/shape_io/clean_mesh.h"
#include "tests/support/brute_force.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

using Outline = std::vector<Eigen::Vector2d>;

/// The prism over an outline, seen counter-clockwise.
TriangleMesh make_prism(const Outline& outline, double height) {
  PolygonMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  const auto add_face = [&](const std::vector<std::uint32_t>& corners) {
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    mesh.face_ends.push_back(mesh.corners.size());
  };
  for (const double z : {0.0, height}) {
    for (const Eigen::Vector2d& p : outline) mesh.vertices.push_back({p.x(), p.y(), z});
  }
  std::vector<std::uint32_t> lower;
  std::vector<std::uint32_t> upper;
  for (std::uint32_t i = 0; i < n; ++i) {
    lower.insert(lower.begin(), i);
    upper.push_back(n + i);
    add_face({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  add_face(lower);
  add_face(upper);
  return clean_mesh(mesh).mesh;
}

TriangleMesh make_box(double x, double y, double z) {
  return make_prism({{0, 0}, {x, 0}, {x, y}, {0, y}}, z);
}

Outline regular_polygon(int corners) {
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    outline.push_back({std::cos(angle), std::sin(angle)});
  }
  return outline;
}

TriangleMesh rotated(TriangleMesh mesh, std::mt19937& random) {
  const Eigen::Vector3d axis = random_point(random, 1.0).normalized();
  const Eigen::AngleAxisd rotation(3.0 * random_point(random, 1.0).x(), axis);
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = rotation * vertex;
  return mesh;
}

std::vector<double> radii_of(const TriangleMesh& mesh, int balls) {
  std::vector<double> radii;
  for (const Ball& ball : decompose(MeshDistanceField(mesh, true), {.balls = balls}).balls) {
    radii.push_back(ball.radius);
  }
  return radii;
}

std::ptrdiff_t count_of(const std::vector<double>& radii, double radius) {
  return std::ranges::count_if(radii, [&](double r) { return std::abs(r - radius) <= 1e-6; });
}

/// Checks that rotated copies have the same radii, and returns them.
std::vector<double> canonical_radii(const TriangleMesh& mesh, int balls, double accuracy = 1e-6) {
  constexpr int rotations = 20;
  std::mt19937 random(1);
  const std::vector<double> radii = radii_of(mesh, balls);
  for (int i = 0; i < rotations; ++i) {
    const std::vector<double> other = radii_of(rotated(mesh, random), balls);
    REQUIRE(other.size() == radii.size());
    double deviation = 0.0;
    for (std::size_t k = 0; k < radii.size(); ++k) {
      deviation = std::max(deviation, std::abs(other[k] - radii[k]));
    }
    CHECK(deviation <= accuracy);
  }
  return radii;
}

}  // namespace

TEST_CASE("a box with room for two largest balls holds both") {
  CHECK(count_of(canonical_radii(make_box(2.5, 1, 1), 60), 0.5) == 2);
  CHECK(count_of(canonical_radii(make_box(3, 1, 1), 60), 0.5) == 3);
}

TEST_CASE("a rod is filled from end to end") {
  const std::vector<double> radii = canonical_radii(make_box(10, 0.2, 0.2), 60);
  CHECK(count_of(radii, 0.1) == 50);
  CHECK(count_of(std::vector(radii.begin(), radii.begin() + 50), 0.1) == 50);
}

TEST_CASE("a plate holds the same number of largest balls however it lies") {
  CHECK(count_of(canonical_radii(make_box(1, 1, 0.1), 110, 1e-5), 0.05) == 98);
}

TEST_CASE("a cube has its known radii in every position") {
  const std::vector<double> radii = canonical_radii(make_box(1, 1, 1), 80);
  CHECK(radii[0] == Approx(0.5).margin(1e-9));
  CHECK(count_of(radii, (std::sqrt(3.0) - 1.0) / (2.0 * (std::sqrt(3.0) + 1.0))) == 8);
}

TEST_CASE("prisms are decomposed alike in every position") {
  SECTION("square") { CHECK(count_of(canonical_radii(make_box(1.9, 1.9, 1), 60), 0.5) == 2); }
  SECTION("hexagonal") {
    CHECK(count_of(canonical_radii(make_prism(regular_polygon(6), 1), 60), 0.5) == 1);
  }
  SECTION("hexagonal and flat") {
    CHECK(count_of(canonical_radii(make_prism(regular_polygon(6), 0.3), 60), 0.15) >= 26);
  }
  SECTION("a disc") { CHECK(canonical_radii(make_prism(regular_polygon(32), 1), 60).size() == 60); }
  SECTION("a flat disc") {
    CHECK(count_of(canonical_radii(make_prism(regular_polygon(64), 0.2), 90, 1e-5), 0.1) >= 70);
  }
  SECTION("L") {
    const Outline outline{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    CHECK(count_of(canonical_radii(make_prism(outline, 1), 60), 0.5) == 6);
  }
  SECTION("T") {
    const Outline outline{{0, 0}, {1, 0}, {1, 3}, {2.5, 3}, {2.5, 4}, {-1.5, 4}, {-1.5, 3}, {0, 3}};
    CHECK(count_of(canonical_radii(make_prism(outline, 1), 60), 0.5) == 7);
  }
}

// The paper's Figures 3 to 5 as extruded solids: a rectangle whose maxima can slide, and the same
// with a small notch that decides between its two ends.
TEST_CASE("a notch decides which end of a rectangle is filled first") {
  const std::vector<double> plain = canonical_radii(make_box(2.3, 1, 1), 40);
  CHECK(count_of(plain, 0.5) == 2);
  const Outline notched{{0, 0}, {2.3, 0}, {2.3, 1}, {0.15, 1}, {0.15, 0.85}, {0, 0.85}};
  const std::vector<double> radii = canonical_radii(make_prism(notched, 1), 40);
  CHECK(count_of(radii, 0.5) == 2);
  // The corners at the notch have no room for what the others hold.
  CHECK(count_of(radii, plain[2]) < count_of(plain, plain[2]));
}

// All corners of the plate are equally good for the first ball; what follows depends on the slot.
TEST_CASE("equally good first balls are told apart by the centroid") {
  const Outline slotted{{0, 0}, {4, 0}, {4, 2}, {0, 2}, {0, 1.5}, {0.6, 1.5}, {0.6, 0.9}, {0, 0.9}};
  CHECK(canonical_radii(make_prism(slotted, 0.3), 100, 1e-5).size() == 100);
}
