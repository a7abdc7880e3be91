#include "features/planar_shape.h"

#include <nlohmann/json.hpp>

#include "features/distance/planar_distance_field.h"
#include "features/shape_io/read_planar_domain.h"
#include "features/shape_unit.h"

namespace mdbd {
namespace {

std::size_t count_vertices(const PlanarDomain& domain) {
  std::size_t count = 0;
  for (const Outline& outline : domain) count += outline.size();
  return count;
}

Shape to_shape(const PlanarFile& file) {
  const nlohmann::ordered_json record = {
      {"unit", unknown_unit},           {"outlines_read", file.outlines_read},
      {"outlines", file.domain.size()}, {"vertices", count_vertices(file.domain)},
      {"area", area(file.domain)},      {"inside", "even-odd rule"}};
  return {.format = file.format,
          .representation = "planar domain",
          .statistics = record.dump(),
          .field = std::make_unique<PlanarDistanceField>(file.domain),
          .surface = file.domain};
}

}  // namespace

Shape load_planar_shape(const std::filesystem::path& path) {
  return to_shape(read_planar_domain(path));
}

Shape make_planar_shape(const PlanarDomain& domain) {
  return to_shape({.domain = simplify(domain), .outlines_read = domain.size()});
}

}  // namespace mdbd
