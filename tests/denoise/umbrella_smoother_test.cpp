#include "features/denoise/umbrella_smoother.h"

#include <catch2/catch.hpp>

#include "features/core/random.h"
#include "tests/denoise/shapes.h"

using namespace mdbd;
using namespace mdbd::test;

namespace {

UmbrellaSmoother make_smoother(const TriangleMesh& mesh) {
  const VertexNeighbours neighbours = find_neighbours(mesh);
  return {neighbours, std::vector<double>(neighbours.vertices.size(), 2.0)};
}

Positions random_positions(std::size_t count) {
  Random random(3);
  Positions positions(count, 3);
  for (Eigen::Index i = 0; i < positions.size(); ++i) {
    positions.data()[i] = random.uniform(-1, 1);
  }
  return positions;
}

}  // namespace

TEST_CASE("no strength changes nothing, and no strength moves a constant") {
  const UmbrellaSmoother smoother = make_smoother(make_sphere(3));
  const Positions noisy = random_positions(make_sphere(3).vertices.size());
  CHECK((smoother.smooth(noisy, 0.0, noisy) - noisy).norm() < 1e-12);
  const Positions constant = Positions::Constant(noisy.rows(), 3, 7.0);
  CHECK((smoother.smooth(constant, 1e4, constant) - constant).norm() < 1e-9);
}

TEST_CASE("the start does not matter beyond the tolerance") {
  const UmbrellaSmoother smoother = make_smoother(make_sphere(4));
  const Positions noisy = random_positions(make_sphere(4).vertices.size());
  const Positions first = smoother.smooth(noisy, 20.0, noisy);
  const Positions second = smoother.smooth(noisy, 20.0, smoother.smooth(noisy, 80.0, noisy));
  CHECK((first - second).norm() < 0.01 * first.norm());
}

TEST_CASE("a straight border stays where it is") {
  const TriangleMesh sheet = make_sheet(20);
  const UmbrellaSmoother smoother = make_smoother(sheet);
  Positions positions(sheet.vertices.size(), 3);
  for (std::size_t i = 0; i < sheet.vertices.size(); ++i) {
    positions.row(static_cast<Eigen::Index>(i)) = sheet.vertices[i].transpose();
  }
  const Positions smooth = smoother.smooth(positions, 1.0, positions);
  const auto moved = [&](Eigen::Index vertex) {
    return (smooth.row(vertex) - positions.row(vertex)).norm();
  };
  CHECK(moved(10) < 1e-3);            // the middle of a side
  CHECK(moved(10 * 21 + 10) < 1e-3);  // of the sheet
}

TEST_CASE("the response is how much of random positions stays") {
  CHECK(UmbrellaSmoother::response(0.0) == Approx(1.0));
  for (const NamedMesh& shape : fine_meshes()) {
    const UmbrellaSmoother smoother = make_smoother(shape.mesh);
    const Positions noise = random_positions(shape.mesh.vertices.size());
    for (const double strength : {0.5, 4.0, 32.0}) {
      INFO(shape.name << ", strength " << strength);
      const Positions smooth = smoother.smooth(noise, strength, noise);
      const double stays = smooth.cwiseProduct(noise).sum() / noise.squaredNorm();
      CHECK(stays == Approx(UmbrellaSmoother::response(strength)).epsilon(0.2));
    }
  }
}

TEST_CASE("a neighbour of no weight does not count") {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  const VertexNeighbours neighbours = find_neighbours(mesh);
  REQUIRE(neighbours.vertices == std::vector<std::uint32_t>{1, 2, 0, 2, 0, 1});
  const UmbrellaSmoother smoother(neighbours, std::vector<double>{1, 0, 1, 0, 1, 0});
  Positions noisy(3, 3);
  noisy << 0, 0, 0, 4, 0, 0, 4, 8, 0;
  const Positions smooth = smoother.smooth(noisy, 1e3, noisy);
  CHECK((smooth.row(0) - smooth.row(1)).norm() < 0.01);
  CHECK((smooth.row(0) - smooth.row(2)).norm() < 0.01);
  CHECK((smooth.colwise().mean() - noisy.colwise().mean()).norm() < 0.01);
}
