#pragma once

#include <span>
#include <string>

#include "bench/comparison.h"
#include "report/report.h"

namespace mdbd::bench {

/// Tables of time, work and quality over all models, and the slowest models; as data, every number
/// of every model.
/// @pre comparisons is not empty
Report make_comparison_report(const std::string& title,
                              std::span<const ModelComparison> comparisons);

}  // namespace mdbd::bench
