#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace mdbd {

/// Opens a regular file for reading bytes.
/// @throws IoError if the file is missing, unreadable or anything but a regular file (a pipe would
///         block, a device would never end); the message gives the reason without the path
std::ifstream open_input_file(const std::filesystem::path& path);

/// The bytes of a regular file.
/// @throws IoError as open_input_file, and if reading fails
/// @throws InvalidInput if the file is empty or larger than 2 GiB, the most that the indices of a
///         mesh are made for
std::string read_input_file(const std::filesystem::path& path);

/// The first bytes of a regular file; fewer if it has no more.
/// @throws IoError as open_input_file, and if reading fails
std::string read_beginning(const std::filesystem::path& path, std::size_t size);

}  // namespace mdbd
