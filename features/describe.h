#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "features/core/descriptor.h"
#include "features/core/recipe.h"
#include "features/decomposition/ball_decomposition.h"
#include "features/shape.h"

namespace mdbd {

/// Everything that is computed from one shape file.
struct ShapeDescription {
  std::string format;          ///< of the file: "off", "pcd", …
  std::string representation;  ///< "mesh", "point cloud", "voxel grid", …
  std::string statistics;      ///< a JSON object: what was read and what was done to it
  BallDecomposition decomposition;
  Descriptor descriptor;
  std::vector<float> fused;    ///< mdbd-fused
  std::string thumbnail = {};  ///< a PNG file if a picture was drawn (picture/thumbnail.h)
};

/// Decomposes a shape and computes its signatures.
/// @throws InvalidInput if it encloses nothing
ShapeDescription describe_shape(const Shape& shape, const Recipe& recipe);

/// Reads a shape and describes it.
/// @throws IoError if the file cannot be read
/// @throws InvalidInput if it is no usable shape or encloses nothing; the message does not name the
///         file
ShapeDescription describe_file(const std::filesystem::path& path, const Recipe& recipe);

}  // namespace mdbd
