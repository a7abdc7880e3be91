#pragma once

#include <string>

#include "report/report.h"

namespace mdbd {

/// A bar chart as an svg element. Where bars side by side would be too narrow to see, each series
/// has a panel of its own, one below the other. Bars tell their category and value when pointed at.
/// Values that are not finite have no bar. Without any bar to show the result is empty.
std::string svg_bar_chart(const BarChart& chart);

}  // namespace mdbd
