#pragma once

#include <filesystem>
#include <string>

/// Parts of what programs write on standard output.
namespace mdbd {

/// A field of CSV (RFC 4180): in quotes if it needs them.
std::string csv_field(const std::string& field);

/// A path for people, as printable() and relative to a folder if it is below that.
std::string shown_path(const std::string& path, const std::filesystem::path& directory);

}  // namespace mdbd
