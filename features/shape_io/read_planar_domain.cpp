#include "features/shape_io/read_planar_domain.h"

#include <algorithm>
#include <array>
#include <utility>

#include "features/core/errors.h"
#include "features/shape_io/input_file.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

constexpr std::array<std::string_view, 2> extensions = {".svg", ".wkt"};

bool has_ending(const std::filesystem::path& path, std::string_view ending) {
  return equals_ignoring_case(path.extension().string(), ending);
}

}  // namespace

std::span<const std::string_view> planar_file_extensions() { return extensions; }

bool has_planar_extension(const std::filesystem::path& path) {
  return std::ranges::any_of(extensions, [&](auto ending) { return has_ending(path, ending); });
}

PlanarFile read_planar_domain(const std::filesystem::path& path) {
  const std::string text = read_input_file(path);
  const bool is_svg = has_ending(path, ".svg");
  const PlanarDomain domain = is_svg ? read_svg(text) : read_wkt(text);
  return {
      .format = is_svg ? "svg" : "wkt", .domain = simplify(domain), .outlines_read = domain.size()};
}

}  // namespace mdbd
