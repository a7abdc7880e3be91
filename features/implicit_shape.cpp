#include "features/implicit_shape.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "features/implicit/csg_distance_field.h"
#include "features/implicit/read_csg.h"
#include "features/shape_io/input_file.h"
#include "features/shape_unit.h"

namespace mdbd {

Shape load_implicit_shape(const std::filesystem::path& path) {
  CsgSolid solid = read_csg(read_input_file(path));
  const nlohmann::ordered_json record = {
      {"unit", unknown_unit}, {"surfaces", solid.size()}, {"inside", "formula"}};
  return {.format = "csg",
          .representation = "implicit solid",
          .statistics = record.dump(),
          .field = std::make_unique<CsgDistanceField>(std::move(solid))};
}

}  // namespace mdbd
