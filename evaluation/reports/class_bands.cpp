#include "evaluation/reports/class_bands.h"

namespace mdbd {

std::vector<Band> class_bands(std::span<const LabelledModel> models) {
  std::vector<Band> bands;
  for (const LabelledModel& model : models) {
    if (bands.empty() || bands.back().name != model.label) bands.push_back({model.label, 0});
    ++bands.back().count;
  }
  return bands;
}

}  // namespace mdbd
