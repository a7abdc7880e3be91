#include "bench/rival/distance_transform_rival.h"

#include <cmath>
#include <unordered_set>
#include <utility>

#include "bench/rival/candidate_grid.h"
#include "bench/rival/distance_transform.h"
#include "bench/rival/exact_climb.h"
#include "bench/rival/voxel_grid.h"

namespace mdbd::bench {
namespace {

// The first step of a climb, in voxels.
constexpr double first_step = 0.5;

// From each voxel inside to the centre of the nearest one outside, which is beyond the boundary.
std::vector<float> bound_distances(const TriangleMesh& mesh, const VoxelGrid& grid) {
  std::vector<float> values = squared_distance_transform(voxelise(mesh, grid), grid.counts);
  const auto size = static_cast<float>(grid.voxel_size);
  for (float& value : values) value = size * std::sqrt(value);
  return values;
}

class Rival {
 public:
  Rival(const TriangleMesh& mesh, const DistanceField& field, const RivalOptions& options)
      : minimum_radius_(options.minimum_radius * field.enclosing_ball().radius),
        grid_(make_voxel_grid(mesh, options.resolution)),
        candidates_(grid_, bound_distances(mesh, grid_)),
        climb_(field, minimum_radius_) {}

  RivalDecomposition run(std::size_t balls) {
    while (climb_.balls().size() < balls) {
      const auto voxel = candidates_.find_largest(0.0F);
      if (!voxel) break;
      if (measured_.insert(voxel->index).second) {
        candidates_.limit(*voxel, static_cast<float>(climb_.measure(grid_.center(voxel->index))));
      } else {
        refine(*voxel);
      }
    }
    return {climb_.balls(), climb_.query_count(), grid_.size()};
  }

 private:
  void refine(const CandidateGrid::Voxel& voxel) {
    const Ball ball = climb_.climb(grid_.center(voxel.index), first_step * grid_.voxel_size);
    if (ball.radius > minimum_radius_) {
      climb_.place(ball);
      candidates_.place(ball, voxel.value);
    }
    candidates_.limit(voxel, 0.0F);
  }

  double minimum_radius_;
  VoxelGrid grid_;
  CandidateGrid candidates_;
  ExactClimb climb_;
  std::unordered_set<std::size_t> measured_;  // voxels with an exact value
};

}  // namespace

RivalDecomposition decompose_by_distance_transform(const TriangleMesh& mesh,
                                                   const DistanceField& field,
                                                   const RivalOptions& options) {
  return Rival(mesh, field, options).run(static_cast<std::size_t>(options.balls));
}

}  // namespace mdbd::bench
