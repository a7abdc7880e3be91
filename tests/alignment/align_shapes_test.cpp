#include "features/alignment/align_shapes.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "features/cloud_shape.h"
#include "features/mesh_shape.h"
#include "features/shape.h"
#include "perturbation/surface_sampling.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/temporary_directory.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

constexpr double tolerance = 0.01;
const Recipe recipe{.balls = 150};

/// A shape with its balls.
struct Packed {
  explicit Packed(Shape made) : shape(std::move(made)) {
    balls = decompose_shape(shape, recipe).balls;
  }
  explicit Packed(const TriangleMesh& mesh) : Packed(make_mesh_shape(mesh, recipe)) {}
  operator PackedShape() const {
    return {.field = *shape.field, .balls = balls, .resolution = 2.0 * shape.least_radius};
  }

  Shape shape;
  std::vector<Ball> balls;
};

/// A box with posts on one of its sides: without symmetry.
TriangleMesh make_board(double height) {
  TriangleMesh mesh;
  add_cube(mesh, {0, 0, 0}, 4.0, false);
  for (Eigen::Vector3d& vertex : mesh.vertices)
    vertex = vertex.cwiseProduct(Eigen::Vector3d(2, 1, 0.25));
  const auto add_post = [&](double x, double y, double size) {
    add_cube(mesh, {x, y, 1.1}, size, false);
  };
  add_post(0.2, 0.3, 1.0);
  add_post(6.5, 2.4, 0.7);
  add_post(3.0, 0.2, height);
  return mesh;
}

TriangleMesh moved(TriangleMesh mesh, const Similarity& motion) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = motion(vertex);
  if (motion.mirrors()) {
    for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
  }
  return mesh;
}

}  // namespace

TEST_CASE("a moved, scaled and mirrored shape is laid upon itself") {
  const TriangleMesh board = make_board(1.4);
  const Packed original(board);
  std::mt19937 random(11);
  for (int i = 0; i < 6; ++i) {
    Similarity motion{.rotation = random_rotation(random).toRotationMatrix(),
                      .scale = i < 3 ? 25.4 : 0.001,
                      .translation = random_point(random, 100.0)};
    if (i % 2 == 1) motion.rotation *= Eigen::Vector3d(-1, 1, 1).asDiagonal();
    const Packed copy(moved(board, motion));
    const Alignment alignment = align_shapes(original, copy, tolerance);
    CHECK(alignment.deviation < 1e-6);
    CHECK(alignment.motion.mirrors() == motion.mirrors());
    const double size = copy.shape.field->enclosing_ball().radius;
    for (const Eigen::Vector3d& vertex : board.vertices) {
      CHECK((alignment.motion(vertex) - motion(vertex)).norm() < 1e-4 * size);
    }
  }
}

TEST_CASE("a detail that differs is no small deviation") {
  const Packed board(make_board(1.4));
  const Packed other(make_board(1.1));  // 0.3 of R = 4.6: 6.5 %
  CHECK(align_shapes(board, other, tolerance).deviation > 0.02);
  CHECK(align_shapes(other, board, tolerance).deviation > 0.02);
}

TEST_CASE("what is too thin for the balls is no small deviation, either") {
  TriangleMesh pinned = make_board(1.4);
  TriangleMesh pin;
  add_cube(pin, {0, 0, 0}, 1.0, false);
  const auto first = static_cast<std::uint32_t>(pinned.vertices.size());
  for (const Eigen::Vector3d& vertex : pin.vertices) {
    pinned.vertices.push_back(vertex.cwiseProduct(Eigen::Vector3d(0.02, 0.02, 1.5)) +
                              Eigen::Vector3d(5.0, 1.0, 1.1));
  }
  for (const auto& [a, b, c] : pin.triangles) {
    pinned.triangles.push_back({first + a, first + b, first + c});
  }
  const Packed board(make_board(1.4));
  const Packed other(pinned);
  CHECK(std::ranges::none_of(other.balls, [](const Ball& ball) { return ball.radius < 0.02; }));
  CHECK(align_shapes(board, other, tolerance).deviation > 0.05);
  CHECK(align_shapes(other, board, tolerance).deviation > 0.05);
}

TEST_CASE("a mesh is laid upon the surface that it approximates") {
  const TemporaryDirectory directory;
  const std::filesystem::path file = directory / "torus.json";
  std::ofstream(file) << R"({"format": "mdbd-csg", "solid":
    {"torus": {"radius": 2, "tube_radius": 0.5}}})";
  const Packed exact(load_shape(file, recipe));
  const Packed mesh(make_torus(20.0, 5.0, 80, 40));
  // The sagittas of its edges: 2.5 (1 - cos(pi / 80)) around and 0.5 (1 - cos(pi / 40)) across.
  constexpr double sagittas = 0.0019 + 0.0015;
  const Alignment alignment = align_shapes(exact, mesh, tolerance);
  CHECK(alignment.deviation < sagittas / 2.5);
  CHECK(alignment.motion.scale == Approx(10.0).epsilon(1e-3));
}

TEST_CASE(
    "a cloud is laid upon the mesh that it was sampled from, but for the gaps between points") {
  const TriangleMesh board = make_board(1.4);
  const Packed mesh(board);
  std::mt19937 random(5);
  const Similarity motion{.rotation = random_rotation(random).toRotationMatrix(), .scale = 3.0};
  const Packed cloud(make_cloud_shape(sample_points(moved(board, motion), 8000, 7)));
  CHECK(align_shapes(mesh, cloud, tolerance).deviation < tolerance);
  CHECK(align_shapes(cloud, mesh, tolerance).deviation < tolerance);
  CHECK(align_shapes(cloud, Packed(make_board(1.0)), tolerance).deviation > tolerance);
}
