#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd::bench {

/// Where the cubic voxels of a grid lie. Arrays over the grid have x fastest, then y, then z.
struct VoxelGrid {
  Eigen::Vector3d origin;   ///< the centre of voxel (0, 0, 0), object units
  double voxel_size = 0.0;  ///< object units
  Eigen::Array3i counts;    ///< voxels along each axis

  std::size_t size() const { return static_cast<std::size_t>(counts.x()) * row_count(); }
  /// Rows of voxels along x.
  std::size_t row_count() const { return static_cast<std::size_t>(counts.y()) * counts.z(); }
  Eigen::Vector3d center(std::size_t index) const {
    const auto x = static_cast<double>(index % counts.x());
    const std::size_t row = index / counts.x();
    const std::size_t slice = row / counts.y();
    const auto y = static_cast<double>(row % counts.y());
    const auto z = static_cast<double>(slice);
    return origin + voxel_size * Eigen::Vector3d(x, y, z);
  }
};

/// The grid around a mesh with `resolution` voxels along the longest side of its bounding box and a
/// margin on all sides, so that the outermost voxels are outside.
/// @pre the mesh has an extent; resolution >= 1
VoxelGrid make_voxel_grid(const TriangleMesh& mesh, int resolution);

/// For each voxel, 1 if its centre is inside, else 0. The crossings of each row with the triangles
/// are counted by their direction, so parts may overlap.
/// @pre the mesh is closed, and its triangles face outward
std::vector<std::uint8_t> voxelise(const TriangleMesh& mesh, const VoxelGrid& grid);

}  // namespace mdbd::bench
