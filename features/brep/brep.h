#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "features/brep/geometry.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A part of a face's outline, from node to node of the tessellation, in the parameters (u, v) of
/// its surface.
struct OutlineSide {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
  double first = 0.0;  ///< the curve's parameters at `from` and `to`
  double last = 0.0;
  std::shared_ptr<const ParameterCurve> curve = {};  ///< null: a straight line
};

/// A surface and the part of it that is boundary.
struct BrepFace {
  SurfaceKind kind = SurfaceKind::other;
  Placement placement;  ///< unless `other`
  std::shared_ptr<const ParametricSurface> surface;
  Eigen::Vector2d period = Eigen::Vector2d::Zero();  ///< of u and v; zero if there is none
  bool is_reversed = false;          ///< the outside is opposite to the direction of du x dv
  bool is_polygon = false;           ///< plane with straight edges: its triangles are exact
  std::vector<OutlineSide> outline;  ///< closed loops, all of them, in any order
};

/// An edge of a face, with the parameters of its tessellation in increasing order.
struct BrepEdge {
  CurveKind kind = CurveKind::other;
  Placement placement;  ///< of a circle
  std::shared_ptr<const ParametricCurve> curve;
  std::vector<double> parameters;  ///< two or more; the edge begins and ends with the outer ones
};

/// The boundary of a solid as exact surfaces, and a tessellation that leads to them. Object units.
struct Brep {
  std::vector<BrepFace> faces;
  /// All edges of the faces that are not polygons, each once.
  std::vector<BrepEdge> edges;
  /// Oriented outward. Faces do not share vertices, and the triangles of one face are connected.
  TriangleMesh mesh;
  std::vector<Eigen::Vector2d> parameters;  ///< (u, v) of each vertex of the mesh
  std::vector<std::uint32_t> face_of;       ///< for each triangle of the mesh
  /// For each triangle, and each of its sides from corner to next corner, whether it is the chord
  /// of a curved edge.
  std::vector<std::array<bool, 3>> is_chord;
  /// The boundary separates inside from outside.
  bool is_closed = false;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the boundary
};

}  // namespace mdbd
