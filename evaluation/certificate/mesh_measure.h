#pragma once

#include <memory>

#include <Eigen/Core>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// Distances of points from a mesh, measured in another way than decompositions do: the distance
/// from a triangle is that from its plane or from its edges, triangles are found through Eigen's
/// volume hierarchy, and the winding number adds up the solid angles of all triangles. Slower, and
/// shares no code. Object units.
class MeshMeasure {
 public:
  /// @pre mesh.triangles is not empty; the mesh outlives this object
  explicit MeshMeasure(const TriangleMesh& mesh);
  ~MeshMeasure();
  MeshMeasure(const MeshMeasure&) = delete;
  MeshMeasure& operator=(const MeshMeasure&) = delete;

  const TriangleMesh& mesh() const { return mesh_; }

  /// The distance from the nearest triangle, whatever the side.
  double distance(const Eigen::Vector3d& point) const;

  /// Whether no triangle is nearer than `radius`. Faster than distance().
  bool is_clear(const Eigen::Vector3d& point, double radius) const;

  /// The winding number (van Oosterom and Strackee, The Solid Angle of a Plane Triangle, 1983).
  double winding_number(const Eigen::Vector3d& point) const;

  /// Whether the winding number exceeds one half.
  bool is_inside(const Eigen::Vector3d& point) const { return winding_number(point) > 0.5; }

 private:
  struct Hierarchy;

  const TriangleMesh& mesh_;
  std::unique_ptr<const Hierarchy> hierarchy_;
};

}  // namespace mdbd
