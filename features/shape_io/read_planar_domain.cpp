#include "features/shape_io/read_planar_domain.h"

#include <array>

#include "features/shape_io/input_file.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

constexpr std::array<std::string_view, 2> extensions = {".svg", ".wkt"};

}  // namespace

std::span<const std::string_view> planar_file_extensions() { return extensions; }

PlanarFile read_planar_domain(const std::filesystem::path& path) {
  const std::string text = read_input_file(path);
  const bool is_svg = equals_ignoring_case(path.extension().string(), ".svg");
  const PlanarDomain domain = is_svg ? read_svg(text) : read_wkt(text);
  return {
      .format = is_svg ? "svg" : "wkt", .domain = simplify(domain), .outlines_read = domain.size()};
}

}  // namespace mdbd
