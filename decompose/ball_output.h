#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "decompose/decompose_model.h"

namespace mdbd {

/// The forms in which a decomposition is written.
enum class BallFormat {
  csv,   ///< a header line x,y,z,r and a line a ball
  xyzr,  ///< a line a ball, separated by spaces, without a header
  json,  ///< with the evidence: see format_json
  svg    ///< a picture of a domain in the plane: see format_svg
};

/// The format that the ending of a path stands for, in upper or lower case; none if it is unknown.
std::optional<BallFormat> ball_format_of(const std::filesystem::path& path);

/// Numbers are written in the shortest form that reads back to the same bits. Object units.
std::string format_csv(const BallDecomposition& decomposition);
std::string format_xyzr(const BallDecomposition& decomposition);

/// {"model", "representation", "statistics", "scale", "termination", "balls": [[x, y, z, r], …],
/// "upper_bounds", "contacts": [[i, j], …] with i < j counted from 0, "certificate", "cost",
/// "recipe"}. Bytes of the path that are no UTF-8 become U+FFFD.
std::string format_json(const DecomposedModel& model);

/// A picture: the outlines of a domain in the plane and its discs, in the coordinates of the file,
/// y down as SVG has it. The darker a disc, the later it was placed.
/// @throws InvalidInput if the model is no planar domain
std::string format_svg(const DecomposedModel& model);

/// @throws InvalidInput if the model cannot be written in the format
std::string format_balls(const DecomposedModel& model, BallFormat format);

}  // namespace mdbd
