#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "features/brep/brep.h"
#include "features/distance/convex_faces.h"
#include "features/distance/distance_field.h"
#include "features/distance/flat_regions.h"

namespace mdbd {

/// The flat parts of the faces of a boundary representation: pieces that the decomposition can use
/// as witnesses.
class FlatFaces {
 public:
  /// @param edge_deflection the chords of edges are at most so far from them; object units
  FlatFaces(const Brep& brep, double edge_deflection);

  /// The convex flat piece of the boundary that holds a triangle of the tessellation; empty if
  /// there is none, as beside a curved edge.
  ConvexPolygon piece_of(std::uint32_t triangle) const;

  /// The flat part of the boundary around a point of a triangle.
  FlatRegion around(const Eigen::Vector3d& point, std::uint32_t triangle) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  /// Some of the triangles of the tessellation.
  struct Selection {
    TriangleMesh mesh;
    std::vector<std::uint32_t> number_of;  ///< in `mesh`, for each triangle of the tessellation
    void add(std::uint32_t triangle, const Triangle& corners);
  };

  double edge_deflection_;
  Selection planar_;    ///< triangles of plane faces
  Selection straight_;  ///< those of them without the chord of a curved edge
  std::vector<std::array<Eigen::Vector3d, 3>> corners_;  ///< of the straight ones
  std::unique_ptr<const ConvexFaces> convex_faces_;
  std::unique_ptr<const FlatRegions> regions_;
};

}  // namespace mdbd
