#pragma once

#include <filesystem>
#include <string>

#include "collection/process_pool.h"
#include "decompose/ball_output.h"

namespace mdbd {

/// A decomposition in the form in which it is written.
struct WrittenDecomposition {
  std::string text;
  std::string shortage;  ///< see explain_shortage()
};

/// Decomposes a file and formats the result, in a process of its own.
/// @throws IoError or InvalidInput, with the path in front of the reason, as decompose_model(), and
///         if the process crashed or went beyond its limits
WrittenDecomposition decompose_isolated(const std::filesystem::path& path, const Recipe& recipe,
                                        BallFormat format, const ProcessLimits& limits);

}  // namespace mdbd
