#include "features/brep/solid_path.h"

#include <algorithm>
#include <charconv>

#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

constexpr std::string_view extensions[] = {".step", ".stp", ".iges", ".igs"};

}  // namespace

std::span<const std::string_view> brep_file_extensions() { return extensions; }

bool is_brep_file(const std::filesystem::path& path) {
  return std::ranges::any_of(extensions, [&](std::string_view extension) {
    return equals_ignoring_case(path.extension().string(), extension);
  });
}

SolidPath split_solid_path(const std::filesystem::path& path) {
  const std::string& text = path.native();
  const std::size_t mark = text.rfind('#');
  if (mark == text.npos || text.find_first_not_of("0123456789", mark + 1) != text.npos) {
    return {.file = path};
  }
  SolidPath split{.file = text.substr(0, mark)};
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data() + mark + 1, last, split.solid);
  const bool is_solid = error == std::errc() && split.solid > 0 && text[mark + 1] != '0';
  return is_solid && is_brep_file(split.file) ? split : SolidPath{.file = path};
}

std::string solid_path(const std::string& file, std::size_t solid) {
  return solid == 0 ? file : file + '#' + std::to_string(solid);
}

}  // namespace mdbd
