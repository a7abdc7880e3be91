#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "features/shape_io/triangle_mesh.h"

namespace mdbd {

/// The endings that write_mesh() knows, in lower case with the dot: ".off", …
std::span<const std::string_view> written_mesh_extensions();

/// Whether the ending of a path, in upper or lower case, is one of written_mesh_extensions().
bool has_written_mesh_extension(const std::filesystem::path& path);

/// Writes a mesh in the format that the ending of the path stands for, one of
/// written_mesh_extensions() in upper or lower case: OFF and OBJ as text, PLY and STL binary,
/// little-endian. Every face is written, whatever it joins. read_mesh() of the file gives vertices
/// and faces back, to the bit and in order, if the mesh is clean (clean_mesh.h); but not of STL,
/// which has single precision and no shared vertices, so that vertices that are equal in single
/// precision become one.
///
/// OpenMesh's writers are not used, since they write single precision in every format.
/// The file is written as a whole or not at all (output_file.h).
/// @throws IoError naming the path if it cannot be written
/// @throws InvalidInput if the ending is none of these, or if a coordinate is beyond single
///         precision in STL; the message gives the reason without the path
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace mdbd
