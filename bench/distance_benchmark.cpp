// Distance queries beside brute force, from cold ones to those that a decomposition asks.
#include <algorithm>
#include <mutex>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "bench/generated_shapes.h"
#include "features/decomposition/decompose.h"
#include "features/distance/mesh_distance_field.h"
#include "tests/support/brute_force.h"

namespace {

using namespace mdbd;

constexpr std::size_t query_count = 1024;
constexpr std::size_t recorded_queries = 50'000;

// How far apart the queries of a pair are, as those of a cell and its child.
constexpr double warm_distance = 0.02;

std::vector<DistanceQuery> random_queries() {
  std::mt19937 random(1);
  std::vector<DistanceQuery> queries(query_count);
  for (DistanceQuery& query : queries) query.point = test::random_point(random, 1.0);
  return queries;
}

// Tells the side, so that the field need not find it.
std::vector<DistanceQuery> queries_with_side(const MeshDistanceField& field) {
  std::vector<DistanceQuery> queries = random_queries();
  for (DistanceQuery& query : queries) {
    query.side = field.measure(query).distance > 0 ? Side::inside : Side::outside;
  }
  return queries;
}

// Tells also what a measurement nearby says of the distance.
std::vector<DistanceQuery> warm_queries(const MeshDistanceField& field) {
  std::mt19937 random(2);
  std::vector<DistanceQuery> queries = queries_with_side(field);
  for (DistanceQuery& query : queries) {
    const Eigen::Vector3d near = query.point + test::random_point(random, warm_distance);
    query.bound = (field.measure({.point = near}).closest - query.point).norm() * (1.0 + 1e-12);
  }
  return queries;
}

// Passes queries on and keeps the first of them.
class RecordingField final : public DistanceField {
 public:
  explicit RecordingField(const DistanceField& field) : field_(field) {}

  using DistanceField::measure;
  Ball enclosing_ball() const override { return field_.enclosing_ball(); }
  bool is_closed() const override { return field_.is_closed(); }
  void measure(std::span<const DistanceQuery> queries,
               std::span<DistanceSample> samples) const override {
    field_.measure(queries, samples);
    const std::lock_guard lock(mutex_);
    const std::size_t room = recorded_queries - queries_.size();
    const auto recorded = queries.first(std::min(room, queries.size()));
    queries_.insert(queries_.end(), recorded.begin(), recorded.end());
  }

  const std::vector<DistanceQuery>& queries() const { return queries_; }

 private:
  const DistanceField& field_;
  mutable std::mutex mutex_;
  mutable std::vector<DistanceQuery> queries_;
};

std::vector<DistanceQuery> queries_of_decomposition(const MeshDistanceField& field) {
  const RecordingField recorder(field);
  decompose(recorder);
  return recorder.queries();
}

void count_queries(benchmark::State& state, std::size_t queries) {
  using benchmark::Counter;
  state.counters["per_query"] =
      Counter(static_cast<double>(queries), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

template <typename MakeQueries>
void measure_queries(benchmark::State& state, const TriangleMesh& mesh,
                     const MakeQueries& make_queries) {
  const MeshDistanceField field(mesh, true);
  const std::vector<DistanceQuery> queries = make_queries(field);
  std::vector<DistanceSample> samples(queries.size());
  for (auto _ : state) {
    field.measure(queries, samples);
    benchmark::DoNotOptimize(samples.data());
  }
  count_queries(state, queries.size());
}

void without_side(benchmark::State& state) {
  measure_queries(state, bench::make_ring(state.range(0)),
                  [](const MeshDistanceField&) { return random_queries(); });
}
void with_side(benchmark::State& state) {
  measure_queries(state, bench::make_ring(state.range(0)), queries_with_side);
}
void warm(benchmark::State& state) {
  measure_queries(state, bench::make_ring(state.range(0)), warm_queries);
}
void in_decomposition(benchmark::State& state) {
  measure_queries(state, bench::make_ring(state.range(0)), queries_of_decomposition);
}
void in_decomposition_of_torus(benchmark::State& state) {
  measure_queries(state, bench::make_torus(state.range(0)), queries_of_decomposition);
}

void by_brute_force(benchmark::State& state) {
  const TriangleMesh mesh = bench::make_ring(state.range(0));
  const std::vector<DistanceQuery> queries = random_queries();
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(test::mesh_distance(mesh, queries[next++ % queries.size()].point));
  }
  count_queries(state, 1);
}

void by_triangles(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgName("triangles")->Arg(1'000)->Arg(20'000)->Arg(500'000);
}

BENCHMARK(without_side)->Apply(by_triangles);
BENCHMARK(with_side)->Apply(by_triangles);
BENCHMARK(warm)->Apply(by_triangles);
BENCHMARK(in_decomposition)->Apply(by_triangles);
BENCHMARK(in_decomposition_of_torus)->ArgName("triangles")->Arg(1'000)->Arg(20'000);
BENCHMARK(by_brute_force)->ArgName("triangles")->Arg(1'000)->Arg(20'000);

}  // namespace
