#pragma once

#include <string>

#include "report/report.h"

namespace mdbd {

/// A line chart as an svg element. Points that are not finite interrupt their line, as do, on a
/// logarithmic axis, those that are not positive. Without any point to show the result is empty.
std::string svg_line_chart(const LineChart& chart);

}  // namespace mdbd
