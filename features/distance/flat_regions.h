#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "features/distance/distance_field.h"
#include "features/distance/triangle_tree.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Where the surface of a mesh is flat: neighbouring triangles in one plane make up regions, of any
/// outline, whatever diagonals and cuts a file has.
class FlatRegions {
 public:
  /// Joins triangles whose planes agree to 1e-12 of the size of the mesh.
  explicit FlatRegions(const TriangleMesh& mesh);

  /// The region around a point of a triangle, with a radius (object units) that may be less than
  /// the truth. Radius zero if the triangle was joined to no other.
  /// @param triangle its number in the mesh
  FlatRegion around(const Eigen::Vector3d& point, std::uint32_t triangle) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<std::uint32_t> region_of_;  // for each triangle; empty if nothing was joined
  std::vector<Eigen::Vector3d> normals_;  // for each region: of its largest triangle
  std::optional<TriangleTree> creases_;   // the outlines of all regions of several triangles
};

}  // namespace mdbd
