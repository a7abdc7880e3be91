#pragma once

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A mesh after denoise_mesh() and what was done to it.
struct DenoisedMesh {
  TriangleMesh mesh;      ///< the faces are those of the input
  double noise = 0.0;     ///< the level of the noise found, relative to R; 0 if there is none
  double strength = 0.0;  ///< of the smoothing, as UmbrellaSmoother has it, geometric mean; or 0
};

/// Takes noise from the vertices of a mesh. A mesh without significant noise (see estimate_noise())
/// comes back as it is, to the bit.
///
/// The mesh is smoothed with a ladder of strengths. Near each vertex the one is taken whose
/// expected squared error along the normal is the smallest: with noise of level s and a response h
/// of the smoother, moving vertices by m along the normal leaves m² - s² + 2 s² h in the mean
/// (Stein, Estimation of the Mean of a Multivariate Normal Distribution, 1981). So plane and evenly
/// curved parts are smoothed more than edges and tips, and the parts taken from different strengths
/// are blended. This is done twice; the second time neighbours count the less the more their
/// normals differ in the first result, so that edges stay sharper.
///
/// Deterministic; a copy that is moved, turned, mirrored, scaled or listed in another order gives
/// the same surface up to rounding. Time and memory are linear in the size of the mesh.
/// @pre mesh.vertices is not empty
DenoisedMesh denoise_mesh(TriangleMesh mesh);

}  // namespace mdbd
