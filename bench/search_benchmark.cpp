// Exact search for the ten nearest: ours beside FLANN's own ways, a plain scan with vector
// instructions and, where it is installed, FAISS. One query, one thread.
#include <algorithm>
#include <chrono>
#include <map>
#include <queue>
#include <string>

#include <benchmark/benchmark.h>
#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>
#include <flann/algorithms/linear_index.h>

#include "bench/descriptor_vectors.h"
#include "query/exact_search.h"

#ifdef MDBD_HAS_FAISS
#include <faiss/IndexFlat.h>
#include <omp.h>
#endif

namespace {

using namespace mdbd;

constexpr std::size_t nearest = 10;
constexpr std::size_t query_count = 64;

enum class Kind { mdbd_100, fused };

std::unique_ptr<const SignatureMetric> make_metric(Kind kind) {
  return kind == Kind::fused ? fused_metric() : similarity_metric(50, 1.0);
}

/// The vectors one after the other, as the libraries want them.
struct Matrix {
  std::vector<float> values;
  std::size_t rows = 0;
  std::size_t dimension = 0;

  std::span<const float> row(std::size_t index) const {
    return std::span(values).subspan(index * dimension, dimension);
  }
};

const VectorTable& vectors(Kind kind, std::size_t count) {
  static std::map<std::pair<Kind, std::size_t>, VectorTable> made;
  const auto key = std::pair(kind, count);
  if (!made.contains(key)) {
    made.clear();  // one at a time: a million take a gigabyte
    made[key] = kind == Kind::fused ? mdbd_fused_vectors(count) : mdbd_100_vectors(count);
  }
  return made[key];
}

Matrix matrix_of(const VectorTable& of) {
  const std::span<const float> values = of.arrays().values;
  return {{values.begin(), values.end()}, of.size(), of.dimension()};
}

/// Queries between models: each is the mean of two of a cluster.
std::vector<std::vector<float>> queries(const VectorTable& of) {
  std::vector<std::vector<float>> result;
  for (std::size_t i = 0; i < query_count; ++i) {
    const std::size_t row = i * (of.size() / query_count);
    std::vector<float> query(of.values(row).begin(), of.values(row).end());
    for (std::size_t j = 0; j < query.size(); ++j) {
      query[j] = 0.5F * (query[j] + of.values(row + 1)[j]);
    }
    result.push_back(std::move(query));
  }
  return result;
}

template <typename Search>
void run(benchmark::State& state, const VectorTable& of, const Search& search) {
  const std::vector<std::vector<float>> all = queries(of);
  std::size_t next = 0;
  for (auto _ : state) {
    search(all[next]);
    next = (next + 1) % all.size();
  }
}

template <Kind kind, SearchMethod method>
void exact_search(benchmark::State& state) {
  const auto& of = vectors(kind, static_cast<std::size_t>(state.range(0)));
  const auto started = std::chrono::steady_clock::now();
  const ExactSearch search(of, make_metric(kind), 1, method);
  const std::chrono::duration<double> built = std::chrono::steady_clock::now() - started;
  std::size_t examined = 0;
  run(state, of, [&](const std::vector<float>& query) {
    examined += search.search(query, {.count = nearest}).examined;
  });
  state.counters["build_s"] = built.count();
  state.counters["examined"] =
      static_cast<double>(examined) / static_cast<double>(state.iterations());
}

template <Kind kind>
void plain_scan(benchmark::State& state) {
  const auto& of = vectors(kind, static_cast<std::size_t>(state.range(0)));
  const Matrix matrix = matrix_of(of);
  const std::vector<MetricBlock> blocks = make_metric(kind)->blocks(matrix.dimension);
  run(state, of, [&](const std::vector<float>& query) {
    std::priority_queue<std::pair<double, std::size_t>> best;
    for (std::size_t row = 0; row < matrix.rows; ++row) {
      const double distance = block_distance(query, matrix.row(row), blocks);
      if (best.size() == nearest && distance >= best.top().first) continue;
      best.emplace(distance, row);
      if (best.size() > nearest) best.pop();
    }
    benchmark::DoNotOptimize(best.top());
  });
}

// With L2 in place of the similarity distance of mdbd-100, which favours FLANN.
template <Kind kind, template <typename> typename Index>
void flann_index(benchmark::State& state) {
  using Distance = std::conditional_t<kind == Kind::fused, flann::L1<float>, flann::L2<float>>;
  const auto& of = vectors(kind, static_cast<std::size_t>(state.range(0)));
  Matrix matrix = matrix_of(of);
  Index<Distance> index;
  const auto started = std::chrono::steady_clock::now();
  index.buildIndex(flann::Matrix<float>(matrix.values.data(), matrix.rows, matrix.dimension));
  const std::chrono::duration<double> built = std::chrono::steady_clock::now() - started;
  run(state, of, [&](std::vector<float> query) {
    std::vector<std::vector<std::size_t>> rows;
    std::vector<std::vector<float>> distances;
    index.knnSearch(flann::Matrix<float>(query.data(), 1, query.size()), rows, distances, nearest,
                    flann::SearchParams());
    benchmark::DoNotOptimize(rows);
  });
  state.counters["build_s"] = built.count();
}

#ifdef MDBD_HAS_FAISS
template <Kind kind>
void faiss_flat(benchmark::State& state) {
  omp_set_num_threads(1);
  const auto& of = vectors(kind, static_cast<std::size_t>(state.range(0)));
  const Matrix matrix = matrix_of(of);
  faiss::IndexFlat index(static_cast<int>(matrix.dimension),
                         kind == Kind::fused ? faiss::METRIC_L1 : faiss::METRIC_L2);
  index.add(static_cast<faiss::Index::idx_t>(matrix.rows), matrix.values.data());
  run(state, of, [&](const std::vector<float>& query) {
    std::array<float, nearest> distances{};
    std::array<faiss::Index::idx_t, nearest> rows{};
    index.search(1, query.data(), nearest, distances.data(), rows.data());
    benchmark::DoNotOptimize(rows);
  });
}
#endif

template <typename Function>
void add(const std::string& name, Function function, std::size_t rows) {
  benchmark::RegisterBenchmark((name).c_str(), function)
      ->Arg(static_cast<int>(rows))
      ->Unit(benchmark::kMillisecond);
}

template <Kind kind>
void add_all(const std::string& signature, std::size_t rows) {
  add(signature + "/tree", exact_search<kind, SearchMethod::tree>, rows);
  add(signature + "/list", exact_search<kind, SearchMethod::list>, rows);
  add(signature + "/scan", exact_search<kind, SearchMethod::scan>, rows);
  add(signature + "/plain_scan", plain_scan<kind>, rows);
  add(signature + "/flann_linear", flann_index<kind, flann::LinearIndex>, rows);
  add(signature + "/flann_kdtree_single", flann_index<kind, flann::KDTreeSingleIndex>, rows);
#ifdef MDBD_HAS_FAISS
  add(signature + "/faiss_flat", faiss_flat<kind>, rows);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  for (const std::size_t rows : {1'000U, 10'000U, 100'000U, 1'000'000U}) {
    add_all<Kind::mdbd_100>("mdbd-100", rows);
  }
  for (const std::size_t rows : {1'000U, 10'000U, 100'000U, 1'000'000U}) {
    add_all<Kind::fused>("mdbd-fused", rows);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
