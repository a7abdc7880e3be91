#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "features/core/recipe.h"
#include "features/decomposition/ball_decomposition.h"
#include "features/distance/distance_field.h"
#include "features/shape_io/point_cloud.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A shape read from a file, ready to be measured. The one place where a representation is chosen.
struct Shape {
  std::string format;          ///< of the file: "off", "pcd", …
  std::string representation;  ///< "mesh" or "point cloud"
  std::string statistics;      ///< a JSON object: what was read and what was done to it
  std::unique_ptr<const DistanceField> field;
  /// The representation says nothing of smaller balls, which are not placed; object units.
  double least_radius = 0.0;
};

/// Reads a shape and prepares it as the recipe says: see prepare_surface().
/// @throws IoError if the file cannot be read
/// @throws InvalidInput if it is no usable shape; the message does not name the file
Shape load_shape(const std::filesystem::path& path, const Recipe& recipe);

/// The shape of a mesh that is in memory, cleaned in the way of read_mesh() and prepared.
/// @throws InvalidInput if it is no usable shape
Shape make_mesh_shape(const TriangleMesh& mesh, const Recipe& recipe);

/// The shape of a point cloud that is in memory.
/// @throws InvalidInput if it is no usable shape
Shape make_cloud_shape(const PointCloud& cloud);

/// The least radius of the balls of a shape, relative to R: the recipe's, or the shape's own if
/// that is larger.
double minimum_radius(const Shape& shape, const Recipe& recipe);

/// The mesh from which the shape of a clean mesh measures its distances. On a closed surface faces
/// and shells that are the wrong way round are turned (orient_shells()); unless the recipe switches
/// that off, noise is taken away (denoise_mesh()) and a surface that encloses nothing is given a
/// thickness (solidify_mesh()). A clean solid is the same mesh.
/// @throws InvalidInput if it encloses nothing and the recipe does not allow to give it a thickness
TriangleMesh prepare_surface(TriangleMesh mesh, const Recipe& recipe);

/// Decomposes a shape as the recipe says.
/// @throws InvalidInput if it encloses no ball of the minimum radius
BallDecomposition decompose_shape(const Shape& shape, const Recipe& recipe);

}  // namespace mdbd
