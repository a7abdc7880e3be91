#pragma once

#include "features/denoise/vertex_neighbours.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// What the surface itself tells about random displacements of its vertices. Lengths are in object
/// units.
struct NoiseEstimate {
  /// The standard deviation of the displacement along the normal. Without noise, a bound of what
  /// could hide in the surface, or zero.
  double level = 0.0;
  /// How alike the lowest of the local levels are, their 5 % quantile relative to their 20 % one:
  /// above 0.8 for noise, which is equally strong everywhere; mostly far below for the residuals
  /// that details of a shape leave.
  double evenness = 0.0;
  /// The share of the neighbours with residuals on the same side: below one half for noise, mostly
  /// above for details of a shape.
  double same_side = 0.0;
  /// The share of the edges whose two faces are in one plane, up to a tenth of the level: about 0.1
  /// for noise, more than 0.25 for models with flat polygons.
  double flatness = 0.0;
  /// Whether it is noise: strong enough to matter, equal everywhere, uncorrelated.
  bool is_significant = false;
};

/// Estimates the noise of a mesh whose vertices were displaced independently of each other.
///
/// The residuals of a vertex and the two rings around it from their least-squares quadric give a
/// local level for each vertex; a low quantile of these, corrected for being one, is the level of
/// the noise. It is significant if it is at least `smallest_noise` and the three other measures
/// are those of noise: they tell it from the details of a shape. Most clean meshes are settled by a
/// cheaper bound, the heights of vertices above their neighbours.
///
/// The result depends on the order of vertices and faces, on position and on scale by rounding
/// only. Time and memory are linear in the size of the mesh.
/// @param scale R, the radius of the smallest enclosing ball
/// @pre neighbours are those of the mesh
NoiseEstimate estimate_noise(const TriangleMesh& mesh, const VertexNeighbours& neighbours,
                             double scale);

/// Noise below this level, relative to R, is left alone: it moves the descriptor little, and clean
/// meshes have details of that size.
inline constexpr double smallest_noise = 1.5e-3;

}  // namespace mdbd
