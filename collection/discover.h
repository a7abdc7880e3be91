#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace mdbd {

/// A model file as the file system shows it.
struct FoundFile {
  std::string path;              ///< absolute and lexically normal
  std::uint64_t size = 0;        ///< bytes
  std::int64_t modified_ns = 0;  ///< modification time, nanoseconds since the epoch
};

/// Something that should be a model, or should hold models, and cannot be read.
struct UnusablePath {
  std::string path;    ///< absolute and lexically normal
  std::string reason;  ///< without the path
};

/// What lies at and below some paths. Everything is ordered by path and there only once.
struct Discovery {
  std::chrono::steady_clock::time_point started;  ///< when the search began
  std::vector<std::string> roots;  ///< the paths asked for, absolute and lexically normal
  std::vector<FoundFile> files;
  std::vector<UnusablePath> unusable;
};

/// Finds the regular files that are models (is_shape_file) at and below some paths; those asked for
/// by name need only the ending of one, and may be one solid of a CAD file (solid_path.h).
///
/// Hidden files and folders (".git") and links to folders are passed over, unless asked for by
/// name. Unusable are: what has the ending of a model and is a folder (it is still searched), a
/// broken link, a pipe, a socket or a device; a folder that cannot be read or searched; a file
/// asked for by name whose ending is not that of a model.
/// @throws IoError if one of the paths does not exist
Discovery discover(std::span<const std::filesystem::path> paths);

/// As discover(), but a path that does not exist is passed over, and is no root.
Discovery discover_existing(std::span<const std::filesystem::path> paths);

/// Looks at files and folders that have changed below the paths of an earlier discovery, as that
/// would: what does not exist, or is no model, is passed over, but all are roots.
/// @param paths absolute and lexically normal
Discovery discover_changed(std::span<const std::filesystem::path> paths);

/// Whether a path is one of the roots of a discovery, a solid of one or lies below one.
bool is_within(const std::string& path, std::span<const std::string> roots);

}  // namespace mdbd
