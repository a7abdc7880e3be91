#include "features/voxel/iso_surface.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "features/core/errors.h"
#include "features/shape_io/mesh_statistics.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/voxel_writers.h"

namespace mdbd::test {
namespace {

double volume(const TriangleMesh& mesh) { return six_volumes(mesh) / 6.0; }

void check_closed(const TriangleMesh& mesh) {
  const MeshStatistics statistics = measure_statistics(mesh);
  CHECK(statistics.watertight);
  CHECK(statistics.orientation == Orientation::outward);
}

}  // namespace

TEST_CASE("The surface of signed distances is of second order") {
  const double exact = 4.0 / 3.0 * std::numbers::pi;
  std::vector<double> errors;
  for (const std::size_t points : {17, 33, 65}) {
    const IsoSurface surface = find_iso_surface(sample_grid(points, 1.3, ball_distance_at));
    CHECK(surface.kind == "signed distance");
    CHECK(surface.value == 0.0);
    CHECK(surface.inside == "above");
    check_closed(surface.mesh);
    errors.push_back(std::abs(volume(surface.mesh) - exact));
  }
  CHECK(errors[0] / errors[1] == Approx(4.0).epsilon(0.3));
  CHECK(errors[1] / errors[2] == Approx(4.0).epsilon(0.3));
}

TEST_CASE("The border says which sign is outside") {
  const auto negative = [](const Eigen::Vector3d& x) { return -ball_distance_at(x); };
  const IsoSurface inverse = find_iso_surface(sample_grid(33, 1.3, negative));
  CHECK(inverse.inside == "below");
  check_closed(inverse.mesh);
  const IsoSurface plain = find_iso_surface(sample_grid(33, 1.3, ball_distance_at));
  CHECK(volume(inverse.mesh) == Approx(volume(plain.mesh)));
}

TEST_CASE("Occupancy is cut in the middle of its range") {
  const auto filled = [](const Eigen::Vector3d& x) { return x.norm() < 1 ? 255.0 : 55.0; };
  const IsoSurface surface = find_iso_surface(sample_grid(41, 1.3, filled));
  CHECK(surface.kind == "occupancy");
  CHECK(surface.value == 155.0);
  CHECK(surface.inside == "above");
  check_closed(surface.mesh);
  CHECK(volume(surface.mesh) == Approx(4.0 / 3.0 * std::numbers::pi).epsilon(0.03));
}

TEST_CASE("What reaches the border is closed there") {
  const auto slab = [](const Eigen::Vector3d& x) { return 0.5 - std::abs(x.z()); };
  const IsoSurface surface = find_iso_surface(sample_grid(21, 1.0, slab));
  check_closed(surface.mesh);
  CHECK(volume(surface.mesh) > 4.0);
  CHECK(volume(surface.mesh) < 1.1 * 1.1 * 4.0 * 1.1);
}

TEST_CASE("Turned, mirrored and stretched grids keep their outside") {
  VoxelGrid grid = sample_grid(33, 1.3, ball_distance_at);
  const double plain = volume(find_iso_surface(grid).mesh);
  grid.steps.col(0) *= -2.0;
  const IsoSurface surface = find_iso_surface(grid);
  check_closed(surface.mesh);
  CHECK(volume(surface.mesh) == Approx(2.0 * plain));
}

TEST_CASE("A grid without a surface is refused") {
  const auto constant = [](const Eigen::Vector3d&) { return 1.0; };
  CHECK_THROWS_WITH(find_iso_surface(sample_grid(5, 1.0, constant)),
                    Catch::Contains("the same everywhere"));
}

}  // namespace mdbd::test
