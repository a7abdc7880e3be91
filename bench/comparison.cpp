#include "bench/comparison.h"

#include "bench/cpu_clock.h"
#include "bench/peak_memory.h"
#include "bench/rival/distance_transform_rival.h"
#include "features/distance/mesh_distance_field.h"

namespace mdbd::bench {
namespace {

// Calls a function and notes what that cost.
template <typename Function>
auto measured(const Function& function, MethodRun& run) {
  const PeakMemory memory;
  const double start = cpu_seconds();
  auto result = function();
  run.seconds = cpu_seconds() - start;
  run.peak_memory = memory.increase();
  return result;
}

MethodRun run_rival(const TriangleMesh& mesh, const MeshDistanceField& field, int resolution,
                    const DecompositionOptions& options, std::span<const Ball> reference) {
  MethodRun run;
  const RivalOptions rival_options{
      .resolution = resolution, .balls = options.balls, .minimum_radius = options.minimum_radius};
  const RivalDecomposition result =
      measured([&] { return decompose_by_distance_transform(mesh, field, rival_options); }, run);
  run.queries = result.distance_queries;
  run.cells = result.voxels;
  run.quality = measure_quality(field, result.balls, reference);
  return run;
}

}  // namespace

ModelComparison compare_methods(const std::string& name, const TriangleMesh& mesh,
                                const DecompositionOptions& options) {
  ModelComparison comparison;
  comparison.name = name;
  comparison.triangles = mesh.triangles.size();
  const double start = cpu_seconds();
  const MeshDistanceField field(mesh, true);
  comparison.field_seconds = cpu_seconds() - start;
  MethodRun ours;
  const BallDecomposition certified = measured([&] { return decompose(field, options); }, ours);
  ours.queries = certified.cost.distance_queries;
  ours.cells = certified.cost.cells;
  ours.quality = measure_quality(field, certified.balls, certified.balls);
  comparison.runs = {ours, run_rival(mesh, field, 128, options, certified.balls),
                     run_rival(mesh, field, 256, options, certified.balls)};
  return comparison;
}

}  // namespace mdbd::bench
