// Decompositions by triangles, balls and tolerance. The counters of work are the same on every
// machine; times compare within one run.
#include <cmath>

#include <benchmark/benchmark.h>

#include "bench/generated_shapes.h"
#include "bench/peak_memory.h"
#include "features/decomposition/decompose.h"
#include "features/distance/mesh_distance_field.h"

namespace {

using namespace mdbd;

constexpr std::int64_t usual_triangles = 20'000;
// A circle of 100 corners, as CAD programs write it: long slivers.
constexpr std::int64_t pipe_triangles = 800;
constexpr double megabyte = 1e6;

void building_the_field(benchmark::State& state) {
  const TriangleMesh mesh = bench::make_ring(state.range(0));
  const bench::PeakMemory memory;
  for (auto _ : state) benchmark::DoNotOptimize(MeshDistanceField(mesh, true).is_closed());
  state.counters["peak_MB"] = static_cast<double>(memory.increase()) / megabyte;
}

void decompose_mesh(benchmark::State& state, const TriangleMesh& mesh,
                    const DecompositionOptions& options) {
  const MeshDistanceField field(mesh, true);
  const bench::PeakMemory memory;
  BallDecomposition result;
  for (auto _ : state) result = decompose(field, options);
  state.counters["balls"] = static_cast<double>(result.balls.size());
  state.counters["queries"] = static_cast<double>(result.cost.distance_queries);
  state.counters["cells"] = static_cast<double>(result.cost.cells);
  state.counters["peak_MB"] = static_cast<double>(memory.increase()) / megabyte;
}

void ring_by_triangles(benchmark::State& state) {
  decompose_mesh(state, bench::make_ring(state.range(0)), {});
}
void torus_by_triangles(benchmark::State& state) {
  decompose_mesh(state, bench::make_torus(state.range(0)), {});
}

// The last of many balls are smaller than the usual minimum radius.
void ring_by_balls(benchmark::State& state) {
  decompose_mesh(state, bench::make_ring(usual_triangles),
                 {.balls = static_cast<int>(state.range(0)), .minimum_radius = 1e-4});
}

DecompositionOptions options_of_digits(const benchmark::State& state) {
  return {.radius_tolerance = std::pow(10.0, -static_cast<double>(state.range(0)))};
}

void ring_by_digits(benchmark::State& state) {
  decompose_mesh(state, bench::make_ring(usual_triangles), options_of_digits(state));
}
void bracket_by_digits(benchmark::State& state) {
  decompose_mesh(state, bench::make_bracket(), options_of_digits(state));
}
void pipe_by_digits(benchmark::State& state) {
  decompose_mesh(state, bench::make_pipe(pipe_triangles), options_of_digits(state));
}

// Once: a case takes up to many seconds, and gives the same result every time.
void once(benchmark::internal::Benchmark* benchmark) {
  benchmark->Iterations(1)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}

void with_triangles(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("triangles")->Arg(1'000)->Arg(5'000)->Arg(20'000)->Arg(100'000);
  benchmark->Arg(1'000'000)->Apply(once);
}

void with_balls(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("balls")->Arg(50)->Arg(100)->Arg(500)->Arg(1'000)->Arg(5'000)->Apply(once);
}

void with_digits(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("digits")->DenseRange(1, 6)->Apply(once);
}

BENCHMARK(building_the_field)->Apply(with_triangles);
BENCHMARK(ring_by_triangles)->Apply(with_triangles);
BENCHMARK(torus_by_triangles)->Apply(with_triangles);
BENCHMARK(ring_by_balls)->Apply(with_balls);
BENCHMARK(ring_by_digits)->Apply(with_digits);
BENCHMARK(bracket_by_digits)->Apply(with_digits);
// Finer ones take gigabytes.
BENCHMARK(pipe_by_digits)->ArgName("digits")->DenseRange(1, 4)->Apply(once);

}  // namespace
