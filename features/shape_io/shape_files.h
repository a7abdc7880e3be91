#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace mdbd {

/// The endings of all files that hold shapes, in lower case with the dot: those of meshes, of
/// boundary representations and of point clouds.
std::span<const std::string_view> shape_file_extensions();

/// Whether the ending of a path, in upper or lower case, is one of shape_file_extensions().
bool has_shape_extension(const std::filesystem::path& path);

/// Whether a file that lies in a folder is taken for a shape: by its ending; a text (.txt, .csv)
/// only if its first lines are points, since folders of models hold other texts, too. A text that
/// cannot be read is not.
bool is_shape_file(const std::filesystem::path& path);

}  // namespace mdbd
