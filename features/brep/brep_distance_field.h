#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "features/brep/brep.h"
#include "features/brep/exact_enclosing_ball.h"
#include "features/brep/flat_faces.h"
#include "features/brep/trim.h"
#include "features/distance/closest_point.h"
#include "features/distance/distance_field.h"
#include "features/distance/triangle_tree.h"
#include "features/distance/winding_number.h"

namespace mdbd {

/// The distance field of a boundary representation: distances to the exact surfaces and edges. The
/// tessellation only says which of them may be closest. A point is inside where the winding number
/// of the tessellation is above one half; closer to the boundary than the tessellation is, that of
/// a point on the same side of it.
class BrepDistanceField final : public DistanceField {
 public:
  /// @throws InvalidInput if there are no triangles or no extent, or a surface is singular
  explicit BrepDistanceField(Brep brep);

  // The winding number refers to the tree beside it.
  BrepDistanceField(const BrepDistanceField&) = delete;
  BrepDistanceField& operator=(const BrepDistanceField&) = delete;

  using DistanceField::measure;
  Ball enclosing_ball() const override { return enclosing_ball_; }
  Eigen::Vector3d centroid() const override { return brep_.centroid; }
  bool is_closed() const override { return brep_.is_closed; }
  void measure(std::span<const DistanceQuery> queries,
               std::span<DistanceSample> samples) const override;

  /// How far the surfaces and edges are from their tessellation at most, measured; object units.
  double deflection() const { return deflection_; }

 private:
  /// A part of an edge between two nodes.
  struct Segment {
    std::uint32_t edge;
    std::uint32_t number;  ///< in the edge
  };
  /// The closest point of the boundary.
  struct Nearest {
    Eigen::Vector3d point;
    double squared_distance;
    std::uint32_t element;  ///< a triangle of the tessellation, or behind them a segment
    Eigen::Vector2d uv = Eigen::Vector2d::Zero();  ///< of the point, if it is on a triangle
  };
  class Search;

  void measure_deflection();
  TriangleMesh collect_elements();
  Nearest find_nearest(const Eigen::Vector3d& point, double bound) const;
  bool is_inside(const Eigen::Vector3d& point, const Nearest& nearest) const;
  bool is_behind_face(const Eigen::Vector3d& point, const Nearest& nearest) const;
  bool is_segment(std::uint32_t element) const { return element >= brep_.mesh.triangles.size(); }

  Brep brep_;
  std::vector<Segment> segments_;
  std::vector<Trim> trims_;  ///< of each face
  Deflections deflections_;
  double deflection_ = 0.0;
  Ball enclosing_ball_;
  std::unique_ptr<const TriangleTree> faces_;     ///< the triangles, for the winding number
  std::unique_ptr<const TriangleTree> elements_;  ///< triangles and segments
  std::unique_ptr<const WindingNumber> winding_number_;
  std::unique_ptr<const FlatFaces> flat_faces_;
};

}  // namespace mdbd
