#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "collection/process_pool.h"
#include "features/core/recipe.h"
#include "features/describe.h"

/// What is done with one file that may be hostile, in a process of its own: a crash, a hang or a
/// memory bomb becomes an exception. The program must not have other threads.
namespace mdbd {

/// Runs a computation in a process of its own.
/// @param file stands in front of the reason if the process ends before the computation, or if that
///        threw something else
/// @returns what the computation returned
/// @throws IoError and InvalidInput with the message that the computation threw
/// @throws InvalidInput with the reason if it threw something else, or if the process crashed or
///         went beyond its limits
/// @throws std::system_error if the system gives no process
std::string compute_isolated(const std::filesystem::path& file, const ProcessLimits& limits,
                             const std::function<std::string()>& compute);

/// describe_file(), or describe_with_thumbnail(), in a process of its own. Of the decomposition
/// only the balls and the scale arrive.
/// @throws IoError or InvalidInput as describe_file(), and InvalidInput with the reason if the
///         process crashed or went beyond its limits; the message does not name the file
/// @throws std::system_error if the system gives no process
ShapeDescription describe_isolated(const std::filesystem::path& file, const Recipe& recipe,
                                   const ProcessLimits& limits, bool has_thumbnail = false);

}  // namespace mdbd
