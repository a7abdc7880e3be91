#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "features/core/convex_polygon.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// The flat convex pieces of a mesh: neighbouring triangles in one plane are joined, as far as they
/// make convex polygons (Hertel and Mehlhorn 1983). The sides of a tessellated prism become
/// rectangles, whatever diagonals a file has.
class ConvexFaces {
 public:
  static constexpr std::size_t max_corners = 16;

  /// Joins triangles whose planes agree to 1e-12 of the size of the mesh.
  explicit ConvexFaces(const TriangleMesh& mesh);

  /// The polygon that a triangle was joined to; empty if it was joined to none.
  ConvexPolygon face_of(std::uint32_t triangle) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<Eigen::Vector3d> corners_;  ///< of all polygons
  std::vector<std::uint32_t> begin_;      ///< of each polygon in corners_, and the end
  std::vector<std::uint32_t> face_of_;    ///< for each triangle; empty if nothing was joined
};

}  // namespace mdbd
