#pragma once

#include <span>
#include <vector>

#include "evaluation/labelled_collection.h"
#include "report/report.h"

namespace mdbd {

/// Classes as bands over models.
/// @pre models of a class follow one another
std::vector<Band> class_bands(std::span<const LabelledModel> models);

}  // namespace mdbd
