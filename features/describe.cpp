#include "features/describe.h"

#include "features/descriptor/compute_descriptor.h"
#include "features/shape.h"

namespace mdbd {

ShapeDescription describe_file(const std::filesystem::path& path, const Recipe& recipe) {
  const Shape shape = load_shape(path);
  ShapeDescription description{.format = shape.format,
                               .representation = shape.representation,
                               .statistics = shape.statistics,
                               .decomposition = decompose_shape(shape, recipe),
                               .descriptor = {}};
  description.descriptor = compute_descriptor(description.decomposition, recipe);
  return description;
}

}  // namespace mdbd
