#pragma once

#include <cstdint>
#include <vector>

#include "features/core/ball.h"
#include "features/distance/distance_field.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd::bench {

/// Options of decompose_by_distance_transform().
struct RivalOptions {
  int resolution = 128;          ///< voxels along the longest side of the bounding box
  int balls = 500;               ///< how many balls are placed at most
  double minimum_radius = 1e-3;  ///< smaller balls are not placed; relative to R
};

/// Disjoint balls in order of placement, without evidence that they are the largest. Object units.
struct RivalDecomposition {
  std::vector<Ball> balls;
  std::uint64_t distance_queries = 0;
  std::uint64_t voxels = 0;
};

/// Disjoint balls inside a closed mesh in the way that is usual without a certificate. The voxel
/// with the largest value of min(Euclidean distance transform, distance from the balls placed) is
/// the next candidate; a climb with exact distances refines it, the ball is placed, and the voxels
/// that it concerns are brought up to date.
/// @param mesh closed, with triangles that face outward
/// @param field the distance field of the same mesh
/// @pre resolution between 1 and 900; balls >= 1
RivalDecomposition decompose_by_distance_transform(const TriangleMesh& mesh,
                                                   const DistanceField& field,
                                                   const RivalOptions& options = {});

}  // namespace mdbd::bench
