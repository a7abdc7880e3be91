#pragma once

#include "features/distance/convex_faces.h"
#include "features/distance/distance_field.h"
#include "features/distance/flat_regions.h"
#include "features/distance/triangle_tree.h"
#include "features/distance/winding_number.h"

namespace mdbd {

/// The distance field of a triangle mesh: exact distances to the triangles; a point is inside where
/// the generalised winding number is above one half.
class MeshDistanceField final : public DistanceField {
 public:
  /// @param is_closed whether the mesh is known to be watertight
  /// @throws InvalidInput if the mesh has no triangles or no extent
  MeshDistanceField(const TriangleMesh& mesh, bool is_closed);

  // The winding number refers to the tree beside it.
  MeshDistanceField(const MeshDistanceField&) = delete;
  MeshDistanceField& operator=(const MeshDistanceField&) = delete;

  using DistanceField::measure;
  Ball enclosing_ball() const override { return enclosing_ball_; }
  Eigen::Vector3d centroid() const override { return centroid_; }
  bool is_closed() const override { return is_closed_; }
  void measure(std::span<const DistanceQuery> queries,
               std::span<DistanceSample> samples) const override;

 private:
  ConvexPolygon piece_of(std::uint32_t triangle) const;

  Ball enclosing_ball_;
  Eigen::Vector3d centroid_;
  bool is_closed_;
  TriangleTree tree_;
  WindingNumber winding_number_;
  ConvexFaces faces_;
  FlatRegions regions_;
};

}  // namespace mdbd
