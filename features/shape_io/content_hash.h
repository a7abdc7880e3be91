#pragma once

#include <filesystem>
#include <string>

namespace mdbd {

/// The XXH3 hash of 128 bits of a file's bytes as 32 lower-case hexadecimal digits. Tells files
/// apart; it is no protection against forgery.
/// @throws IoError if the file is missing, unreadable or not a regular file
std::string content_hash(const std::filesystem::path& path);

}  // namespace mdbd
