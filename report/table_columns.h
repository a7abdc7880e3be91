#pragma once

#include <cstddef>
#include <string_view>

#include "report/report.h"

namespace mdbd {

/// Whether a cell reads as a number, perhaps with a sign, a unit sign or a spread: "81.2 %",
/// "0.05 ± 0.01", "1e-9", "12/40". Neither letters nor an empty cell do.
bool is_number(std::string_view cell);

/// Whether every cell of a column is a number, or empty, "–" or "none", and one is a number. Such
/// columns are set to the right.
bool is_number_column(const Table& table, std::size_t column);

}  // namespace mdbd
