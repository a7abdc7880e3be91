#include "decompose/isolated_decomposition.h"

#include "collection/isolated.h"

namespace mdbd {

WrittenDecomposition decompose_isolated(const std::filesystem::path& path, const Recipe& recipe,
                                        BallFormat format, const ProcessLimits& limits) {
  constexpr char separator = '\0';  // in neither text
  const std::string sent = compute_isolated(path, limits, [&] {
    const DecomposedModel model = decompose_model(path, recipe);
    return explain_shortage(model) + separator + format_balls(model, format);
  });
  const std::size_t end = sent.find(separator);
  return {.text = sent.substr(end + 1), .shortage = sent.substr(0, end)};
}

}  // namespace mdbd
