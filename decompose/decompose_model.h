#pragma once

#include <filesystem>
#include <string>

#include "features/core/recipe.h"
#include "features/decomposition/ball_decomposition.h"
#include "features/decomposition/certificate.h"
#include "features/descriptor/contact_graph.h"
#include "features/planar/planar_domain.h"

namespace mdbd {

/// The decomposition of a file with its evidence.
struct DecomposedModel {
  std::string path;
  std::string representation;  ///< "mesh", "point cloud", "voxel grid", …
  std::string statistics;      ///< a JSON object: what was read and what was done to it
  PlanarDomain outlines;       ///< of a domain in the plane; else empty
  Recipe recipe;
  double minimum_radius;  ///< of a ball, relative to R: see minimum_radius() of a shape
  BallDecomposition decomposition;
  ContactGraph contacts;
  Certificate certificate;
};

/// Reads a shape and decomposes it.
/// @throws IoError or InvalidInput, with the path in front of the reason, if the file cannot be
/// read,
///         is no usable shape or encloses no ball
DecomposedModel decompose_model(const std::filesystem::path& path, const Recipe& recipe);

/// Why there are fewer balls than the recipe asks for, for people; empty if there are not.
std::string explain_shortage(const DecomposedModel& model);

}  // namespace mdbd
