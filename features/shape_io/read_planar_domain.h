#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "features/planar/planar_domain.h"

namespace mdbd {

/// A domain as read from a file, and what was done to it.
struct PlanarFile {
  std::string format = {};  ///< "svg" or "wkt"; empty if there is no file
  PlanarDomain domain;      ///< as simplify() makes it
  std::size_t outlines_read = 0;
};

/// The endings of drawings, in lower case with the dot: ".svg", ".wkt".
std::span<const std::string_view> planar_file_extensions();

/// Reads a domain of the plane:
/// - SVG: all paths and basic shapes of the drawing but those in definitions, with their transforms
///   and whatever their paint; open paths are closed as filling does. Coordinates are user units,
///   y points down. Curves become polygons within 1e-5 of their size. Texts, strokes, clipping,
///   <use> and style sheets are ignored.
/// - WKT, well-known text: one POLYGON or MULTIPOLYGON.
/// What is inside an odd number of outlines is inside the domain.
/// @throws IoError if the file is missing, a directory or unreadable
/// @throws InvalidInput if the content is no such drawing or has no area; the message gives the
///         reason without the path
PlanarFile read_planar_domain(const std::filesystem::path& path);

/// The formats: outlines as they are in the text of a file.
/// @throws InvalidInput with the reason if the text is damaged
PlanarDomain read_svg(const std::string& text);
PlanarDomain read_wkt(const std::string& text);

}  // namespace mdbd
