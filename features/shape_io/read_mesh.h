#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "features/shape_io/mesh_statistics.h"
#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// A mesh as read from a file, with the record of what it is and what was done to it.
struct MeshFile {
  std::string format;  ///< "off", "obj", "gltf", …; empty if there is no file
  std::string unit;    ///< of length, if the format says; coordinates are as in the file anyway
  TriangleMesh mesh;   ///< oriented outward if the file was inverted as a whole
  MeshStatistics statistics;
};

/// The endings that read_mesh understands, in lower case with the dot: ".off", …
std::span<const std::string_view> mesh_file_extensions();

/// Those of them that assimp reads (assimp_reader.h).
std::span<const std::string_view> scene_file_extensions();

/// Whether the ending of a path, in upper or lower case, is one of mesh_file_extensions().
bool has_mesh_extension(const std::filesystem::path& path);

/// Reads a mesh of any format of mesh_file_extensions() and cleans it: polygons are triangulated,
/// exact duplicate vertices welded, degenerate faces and faces with bad indices dropped and
/// counted, a mesh inverted as a whole is turned outward (the statistics still say `inverted`).
/// Memory stays proportional to the size of the file, whatever the file claims.
/// @throws IoError if the file is missing, a directory or unreadable
/// @throws InvalidInput if the content is no usable mesh; the message gives the reason without the
///         path
MeshFile read_mesh(const std::filesystem::path& path);

/// A mesh in memory, cleaned in the same way; its format is empty.
/// @throws InvalidInput if no face remains
MeshFile make_mesh(const TriangleMesh& mesh);

}  // namespace mdbd
