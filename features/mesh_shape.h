#pragma once

#include <filesystem>

#include "features/core/recipe.h"
#include "features/shape.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// The shape of a file that read_mesh() reads.
/// @throws IoError, InvalidInput as load_shape()
Shape load_mesh_shape(const std::filesystem::path& path, const Recipe& recipe);

/// The shape of a mesh that is in memory, cleaned in the way of read_mesh() and prepared.
/// @throws InvalidInput if it is no usable shape
Shape make_mesh_shape(const TriangleMesh& mesh, const Recipe& recipe);

/// The mesh from which the shape of a clean mesh measures its distances. On a closed surface faces
/// and shells that are the wrong way round are turned (orient_shells()); unless the recipe switches
/// that off, noise is taken away (denoise_mesh()) and a surface that encloses nothing is given a
/// thickness (solidify_mesh()). A clean solid is the same mesh.
/// @throws InvalidInput if it encloses nothing and the recipe does not allow to give it a thickness
TriangleMesh prepare_surface(TriangleMesh mesh, const Recipe& recipe);

}  // namespace mdbd
