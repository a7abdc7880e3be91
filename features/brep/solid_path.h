#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace mdbd {

/// The endings of CAD files: .step, .stp, .iges, .igs.
std::span<const std::string_view> brep_file_extensions();

/// Whether the ending of a path, in upper or lower case, is that of a CAD file.
bool is_brep_file(const std::filesystem::path& path);

/// One solid of a CAD file, or a whole file.
struct SolidPath {
  std::filesystem::path file;
  std::size_t solid = 0;  ///< from 1; 0 for all of the file
};

/// "a.step#3" is the third solid of a.step. Every other path is a file, also if it has a "#"
/// elsewhere; no file of a format that is read ends like the path of a solid.
SolidPath split_solid_path(const std::filesystem::path& path);

/// The inverse of split_solid_path().
std::string solid_path(const std::string& file, std::size_t solid);

}  // namespace mdbd
