#include "features/describe.h"

#include "features/descriptor/compute_descriptor.h"
#include "features/descriptor/fused_signature.h"

namespace mdbd {

ShapeDescription describe_shape(const Shape& shape, const Recipe& recipe) {
  ShapeDescription description{.format = shape.format,
                               .representation = shape.representation,
                               .statistics = shape.statistics,
                               .decomposition = decompose_shape(shape, recipe),
                               .descriptor = {},
                               .fused = {}};
  description.descriptor = compute_descriptor(description.decomposition, recipe);
  description.fused = compute_fused_signature(description.decomposition.balls);
  return description;
}

ShapeDescription describe_file(const std::filesystem::path& path, const Recipe& recipe) {
  return describe_shape(load_shape(path, recipe), recipe);
}

}  // namespace mdbd
