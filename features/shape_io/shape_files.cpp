#include "features/shape_io/shape_files.h"

#include <algorithm>
#include <string>
#include <vector>

#include "features/brep/read_brep.h"
#include "features/core/errors.h"
#include "features/shape_io/input_file.h"
#include "features/shape_io/read_mesh.h"
#include "features/shape_io/read_point_cloud.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

constexpr std::size_t beginning_size = 8192;  // bytes

bool may_be_another_text(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return equals_ignoring_case(ending, ".txt") || equals_ignoring_case(ending, ".csv");
}

}  // namespace

std::span<const std::string_view> shape_file_extensions() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> extensions;
    for (const auto of_kind :
         {mesh_file_extensions(), brep_file_extensions(), point_cloud_file_extensions()}) {
      extensions.insert(extensions.end(), of_kind.begin(), of_kind.end());
    }
    return extensions;
  }();
  return all;
}

bool has_shape_extension(const std::filesystem::path& path) {
  return std::ranges::any_of(shape_file_extensions(), [&](std::string_view extension) {
    return equals_ignoring_case(path.extension().string(), extension);
  });
}

bool is_shape_file(const std::filesystem::path& path) {
  if (!may_be_another_text(path)) return has_shape_extension(path);
  try {
    return looks_like_points(read_beginning(path, beginning_size));
  } catch (const IoError&) {
    return false;
  }
}

}  // namespace mdbd
