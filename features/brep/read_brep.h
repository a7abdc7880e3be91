#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "features/brep/brep.h"

namespace mdbd {

/// What a CAD file holds.
struct BrepFile {
  std::string format;     ///< "step" or "iges"
  std::string file_unit;  ///< the unit of length that the file states, such as "INCH"; may be empty
  /// The boundary; coordinates in millimetres, whatever the unit of the file.
  Brep brep;
  std::size_t solids = 0;
  std::size_t faces = 0;          ///< of the boundary
  std::size_t faces_ignored = 0;  ///< that belong to no solid, beside solids
  std::size_t solids_turned = 0;  ///< that were inside out
  bool is_sewn = false;  ///< there was no solid: the faces were sewn, and made one if that closed
};

/// Reads a STEP or IGES file through OpenCASCADE. An assembly is the union of its solids. The
/// tessellation is asked for a deflection of 5e-4 of the size of the shape.
/// @param solid the number of the only solid that is wanted, from 1; 0 for all
/// @throws IoError if the file cannot be read
/// @throws InvalidInput if it is damaged or holds no faces; the message does not name the file
BrepFile read_brep(const std::filesystem::path& path, std::size_t solid = 0);

/// How many solids read_brep() finds in a file, by far faster than that.
/// @throws IoError, InvalidInput as read_brep()
std::size_t count_solids(const std::filesystem::path& path);

}  // namespace mdbd
