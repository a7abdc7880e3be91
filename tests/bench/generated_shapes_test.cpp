#include "bench/generated_shapes.h"

#include <catch2/catch.hpp>

#include "features/shape_io/mesh_statistics.h"

using namespace mdbd;

TEST_CASE("generated shapes are closed and face outward") {
  const TriangleMesh mesh = GENERATE(bench::make_torus(2'000), bench::make_ring(2'000),
                                     bench::make_pipe(2'000), bench::make_bracket());
  const MeshStatistics statistics = measure_statistics(mesh);
  CHECK(statistics.watertight);
  CHECK(statistics.non_manifold_edges == 0);
  CHECK(statistics.orientation == Orientation::outward);
}

TEST_CASE("generated shapes have about the triangles asked for") {
  const std::int64_t triangles = GENERATE(1'000, 20'000);
  const auto wanted = static_cast<double>(triangles);
  CHECK(static_cast<double>(bench::make_torus(triangles).triangles.size()) ==
        Approx(wanted).epsilon(0.1));
  CHECK(static_cast<double>(bench::make_ring(triangles).triangles.size()) ==
        Approx(wanted).epsilon(0.1));
  CHECK(static_cast<double>(bench::make_pipe(triangles).triangles.size()) ==
        Approx(wanted).epsilon(0.1));
}
