// Distance queries beside brute force, and decompositions by triangles, balls and tolerance. The
// counters are the same on every machine; times compare within one run.
#include <cmath>
#include <random>

#include <benchmark/benchmark.h>

#include "features/decomposition/decompose.h"
#include "features/distance/mesh_distance_field.h"
#include "tests/support/brute_force.h"
#include "tests/support/sample_meshes.h"

namespace {

using namespace mdbd;

TriangleMesh torus_of(std::int64_t triangles) {
  const auto across = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4.0));
  return test::make_torus(1.0, 0.35, 2 * across, across);
}

std::vector<DistanceQuery> random_queries() {
  std::mt19937 random(1);
  std::vector<DistanceQuery> queries(256);
  for (DistanceQuery& query : queries) query.point = test::random_point(random, 1.3);
  return queries;
}

void distance_query(benchmark::State& state) {
  const MeshDistanceField field(torus_of(state.range(0)), true);
  const std::vector<DistanceQuery> queries = random_queries();
  std::vector<DistanceSample> samples(queries.size());
  for (auto _ : state) {
    field.measure(queries, samples);
    benchmark::DoNotOptimize(samples.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(queries.size()));
}
BENCHMARK(distance_query)->Arg(1'000)->Arg(20'000)->Arg(500'000);

void distance_by_brute_force(benchmark::State& state) {
  const TriangleMesh mesh = torus_of(state.range(0));
  const std::vector<DistanceQuery> queries = random_queries();
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(test::mesh_distance(mesh, queries[next++ % queries.size()].point));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(distance_by_brute_force)->Arg(1'000)->Arg(20'000);

void decomposition(benchmark::State& state) {
  const MeshDistanceField field(torus_of(state.range(0)), true);
  const DecompositionOptions options{.balls = static_cast<int>(state.range(1)),
                                     .radius_tolerance = std::pow(10.0, -state.range(2))};
  BallDecomposition result;
  for (auto _ : state) result = decompose(field, options);
  state.counters["queries"] = static_cast<double>(result.cost.distance_queries);
  state.counters["cells"] = static_cast<double>(result.cost.cells);
}
BENCHMARK(decomposition)
    ->ArgNames({"triangles", "balls", "digits"})
    ->Args({1'000, 500, 3})
    ->Args({20'000, 50, 3})
    ->Args({20'000, 500, 1})
    ->Args({20'000, 500, 2})
    ->Args({20'000, 500, 3})
    ->Unit(benchmark::kMillisecond);

}  // namespace
