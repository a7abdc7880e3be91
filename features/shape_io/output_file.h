#pragma once

#include <filesystem>
#include <string_view>

namespace mdbd {

/// Writes a file as a whole or not at all: beside its place first, then renamed. A symbolic link is
/// followed.
/// @throws IoError naming the path and the reason
void write_file(const std::filesystem::path& path, std::string_view content);

}  // namespace mdbd
