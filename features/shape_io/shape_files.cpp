#include "features/shape_io/shape_files.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "features/brep/solid_path.h"
#include "features/core/errors.h"
#include "features/shape_io/input_file.h"
#include "features/shape_io/read_mesh.h"
#include "features/shape_io/read_planar_domain.h"
#include "features/shape_io/read_point_cloud.h"
#include "features/shape_io/read_voxel_grid.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

constexpr std::size_t beginning_size = 8192;  // bytes

constexpr std::array<std::string_view, 1> implicit_extensions = {".json"};
constexpr std::array<std::string_view, 3> text_extensions = {".txt", ".csv", ".json"};
constexpr std::string_view csg_format_mark = "\"mdbd-csg\"";

/// Whether a text whose ending says little begins as a shape does.
bool looks_like_shape(const std::filesystem::path& path, std::string_view beginning) {
  if (!has_extension(path, implicit_extensions)) return looks_like_points(beginning);
  return beginning.find(csg_format_mark) != beginning.npos;
}

}  // namespace

std::span<const std::string_view> implicit_file_extensions() { return implicit_extensions; }

std::span<const std::string_view> shape_file_extensions() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> extensions;
    for (const auto of_kind :
         {mesh_file_extensions(), brep_file_extensions(), point_cloud_file_extensions(),
          planar_file_extensions(), voxel_file_extensions(), implicit_file_extensions()}) {
      extensions.insert(extensions.end(), of_kind.begin(), of_kind.end());
    }
    return extensions;
  }();
  return all;
}

bool has_extension(const std::filesystem::path& path,
                   std::span<const std::string_view> extensions) {
  return std::ranges::any_of(extensions, [&](std::string_view extension) {
    return equals_ignoring_case(path.extension().string(), extension);
  });
}

bool has_shape_extension(const std::filesystem::path& path) {
  return has_extension(path, shape_file_extensions());
}

bool is_shape_file(const std::filesystem::path& path) {
  if (!has_extension(path, text_extensions)) return has_shape_extension(path);
  try {
    return looks_like_shape(path, read_beginning(path, beginning_size));
  } catch (const IoError&) {
    return false;
  }
}

}  // namespace mdbd
