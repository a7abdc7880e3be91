#pragma once

#include <string>

#include "report/report.h"

namespace mdbd {

/// A matrix as an svg element that holds a PNG image of one pixel for each value, with a scale of
/// its colours. Values that are not finite are grey. An empty matrix gives an empty result.
/// @throws InvalidInput if there are not size² values
std::string svg_matrix_picture(const MatrixPicture& picture);

}  // namespace mdbd
