#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cli/progress_bar.h"
#include "collection/process_pool.h"
#include "query/duplicates.h"
#include "store/shape_store.h"

namespace mdbd {

/// CompareSurfaces: reads the files of each pair and measures them in a process of its own, on all
/// processors. A pair cannot be compared if a file is gone, has changed since it was indexed or
/// cannot be read, if one of them is a domain in the plane, or if it takes more than the limits.
/// The program must not have other threads.
/// @throws std::system_error if the system gives no process
std::vector<std::optional<double>> compare_surfaces(const ShapeStore& store,
                                                    std::span<const ModelPair> pairs,
                                                    const ProcessLimits& limits,
                                                    ProgressBar& progress);

}  // namespace mdbd
