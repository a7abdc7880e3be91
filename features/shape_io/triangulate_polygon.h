#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Cuts polygons into triangles. Keeps its memory from one polygon to the next.
class PolygonTriangulator {
 public:
  /// Appends the triangles of one polygon, oriented as it is: a fan if it is strictly convex, else
  /// cut off ear by ear in the polygon's own plane, so that no triangle is flat unless it must be.
  /// A polygon that crosses itself gets some triangles with its boundary.
  /// @pre at least three corners, all of them indices into `vertices`
  /// @throws InvalidInput if a polygon that is not convex has more than 10,000 corners
  void triangulate(std::span<const Eigen::Vector3d> vertices,
                   std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles);

 private:
  bool project(std::span<const Eigen::Vector3d> vertices, std::span<const std::uint32_t> corners);
  int turn(std::size_t a, std::size_t b, std::size_t c) const;
  bool is_ear(std::size_t corner) const;
  bool is_strictly_convex() const;
  void clip_ears(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles);
  std::size_t mark_ears(std::size_t start);

  std::vector<Eigen::Vector2d> points_;  // the corners in the plane, within [-1, 1]
  std::vector<std::size_t> previous_;    // of the corners that remain
  std::vector<std::size_t> next_;
  std::vector<char> is_ear_;
};

}  // namespace mdbd
