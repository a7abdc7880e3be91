// Meshes as they are found, each a cube or two with something amiss: the largest ball tells whether
// the inside is where it should be.
#include <algorithm>

#include <catch2/catch.hpp>

#include "features/describe.h"
#include "features/mesh_shape.h"
#include "tests/support/sample_meshes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

std::vector<Ball> balls_of(const TriangleMesh& mesh, int count = 2) {
  const Recipe recipe{.balls = count, .radius_tolerance = 1e-2};
  return decompose_shape(make_mesh_shape(mesh, recipe), recipe).balls;
}

void check_is_cube(const TriangleMesh& mesh) {
  const std::vector<Ball> balls = balls_of(mesh);
  REQUIRE(balls.size() == 2);
  CHECK(balls[0].radius == Approx(0.5));
  CHECK(balls[0].center.isApprox(Eigen::Vector3d(0.5, 0.5, 0.5), 1e-6));
  CHECK(balls[1].radius == Approx(0.1339745962));
}

}  // namespace

TEST_CASE("a cube is found whatever its faces look like") {
  TriangleMesh mesh = make_cube();
  check_is_cube(mesh);
  SECTION("inverted") {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    check_is_cube(mesh);
  }
  SECTION("some faces turned") {
    for (const std::size_t i : {0, 3, 4, 5}) {
      std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
    }
    check_is_cube(mesh);
  }
  SECTION("faces doubled") {
    mesh.triangles.push_back(mesh.triangles[2]);
    mesh.triangles.push_back(mesh.triangles[7]);
    check_is_cube(mesh);
  }
  SECTION("all faces doubled") {
    mesh.triangles.insert(mesh.triangles.end(), mesh.triangles.begin(),
                          mesh.triangles.begin() + 12);
    check_is_cube(mesh);
  }
  SECTION("no shared vertices") {
    TriangleMesh soup;
    for (const Triangle& triangle : mesh.triangles) {
      const auto start = static_cast<std::uint32_t>(soup.vertices.size());
      for (const std::uint32_t corner : triangle) soup.vertices.push_back(mesh.vertices[corner]);
      soup.triangles.push_back({start, start + 1, start + 2});
    }
    check_is_cube(soup);
  }
}

TEST_CASE("an open box is filled") {
  TriangleMesh mesh = make_cube();
  std::erase_if(mesh.triangles, [](const Triangle& triangle) {
    return std::ranges::all_of(triangle, [](std::uint32_t corner) { return corner >= 4; });
  });
  CHECK(balls_of(mesh, 1)[0].radius == Approx(0.5).epsilon(0.01));
}

TEST_CASE("a cavity is not filled") {
  TriangleMesh mesh;
  add_cube(mesh, {0, 0, 0}, 1.0, false);
  add_cube(mesh, {0.25, 0.25, 0.25}, 0.5, true);
  for (const Ball& ball : balls_of(mesh, 20)) {
    const Eigen::Vector3d from_middle = ball.center - Eigen::Vector3d::Constant(0.5);
    CHECK(from_middle.cwiseAbs().maxCoeff() > 0.25);
    CHECK(ball.radius < 0.25);
  }
}

TEST_CASE("shells beside each other are all solid, an inverted one, too") {
  for (const bool is_inverted : {false, true}) {
    TriangleMesh mesh;
    add_cube(mesh, {0, 0, 0}, 1.0, false);
    add_cube(mesh, {3, 0, 0}, 1.0, is_inverted);
    const std::vector<Ball> balls = balls_of(mesh);
    CHECK(balls[0].radius == Approx(0.5));
    CHECK(balls[1].radius == Approx(0.5));
  }
}

TEST_CASE("parts that overlap are one solid") {
  TriangleMesh mesh;
  add_cube(mesh, {0, 0, 0}, 1.0, false);
  add_cube(mesh, {0.9, 0.9, 0.9}, 1.0, false);
  const std::vector<Ball> balls = balls_of(mesh);
  CHECK(balls[0].radius == Approx(0.5).epsilon(0.05));
  CHECK(balls[1].radius == Approx(0.5).epsilon(0.05));
}
