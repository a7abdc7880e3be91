#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include "features/core/recipe.h"
#include "features/decomposition/ball_decomposition.h"
#include "features/distance/distance_field.h"
#include "features/planar/planar_domain.h"
#include "features/shape_io/point_cloud.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// What pictures show of a shape: a mesh, points with normals, outlines in the plane or, of a
/// representation that has no surface at hand, nothing. No number depends on it.
using VisibleSurface = std::variant<std::monostate, TriangleMesh, PointCloud, PlanarDomain>;

/// A shape, ready to be measured. Each representation makes it in files of its own (mesh_shape.h,
/// brep_shape.h, cloud_shape.h); behind `field` nothing knows which it was.
struct Shape {
  std::string format;          ///< of the file: "off", "pcd", …
  std::string representation;  ///< "mesh", "point cloud", "B-rep", …
  std::string statistics;      ///< a JSON object: what was read and what was done to it
  std::unique_ptr<const DistanceField> field;
  /// The representation says nothing of smaller balls, which are not placed; object units.
  double least_radius = 0.0;
  VisibleSurface surface = {};
};

/// Reads a shape and prepares it as the recipe says. The one place where a representation is
/// chosen.
/// @param path of a file, or of one solid of a CAD file: "a.step#3"
/// @throws IoError if the file cannot be read
/// @throws InvalidInput if it is no usable shape; the message does not name the file
Shape load_shape(const std::filesystem::path& path, const Recipe& recipe);

/// Loads what load_shape() will load for a path (features/modules), so that processes that are
/// forked afterwards need not. Never fails: load_shape() says what is missing.
void preload_reader(const std::filesystem::path& path);

/// The least radius of the balls of a shape, relative to R: the recipe's, or the shape's own if
/// that is larger.
double minimum_radius(const Shape& shape, const Recipe& recipe);

/// Decomposes a shape as the recipe says.
/// @throws InvalidInput if it encloses no ball of the minimum radius
BallDecomposition decompose_shape(const Shape& shape, const Recipe& recipe);

}  // namespace mdbd
