#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "collection/process_pool.h"
#include "perturbation/perturbation.h"

namespace mdbd {

struct PerturbOptions {
  Perturbation perturbation;
  std::uint64_t seed = 1;
  double wanted_faces = 0.0;  ///< percent that a decimation is to leave; 0 if there is none
  std::string format;         ///< of the copies: "stl"; empty: that of the models
  std::size_t jobs = 1;
  ProcessLimits limits;  ///< of one model
};

/// A copy to be made.
struct PlannedCopy {
  std::string source;            ///< absolute
  std::string name;              ///< relative to the folder, or the file's name; for people
  std::filesystem::path target;  ///< empty if the copy cannot be made
  std::string problem;           ///< why not
};

/// Which copies of a model or of the models below a folder are made, and where. Unusable paths and
/// models whose copies would overwrite one another are among them, with their problem.
/// @param format as PerturbOptions::format
/// @throws IoError if the input does not exist
/// @throws InvalidInput if there is no model, or if the copies could overwrite models
std::vector<PlannedCopy> plan_copies(const std::filesystem::path& input,
                                     const std::filesystem::path& output,
                                     const std::string& format);

/// What became of a copy.
struct CopyOutcome {
  std::string problem;  ///< why there is none; empty if there is
  std::string remark;   ///< what is to be said of it; mostly empty
};

/// Hears about a run while it goes on, and can end it.
struct PerturbObserver {
  std::function<void(const PlannedCopy&, const CopyOutcome&)> on_done;
  std::function<void()> on_wait;  ///< about ten times a second
  std::function<bool()> is_interrupted;
};

/// Makes the copies, each in a process of its own, and the folders above them.
/// @returns how many copies were left out because the run was interrupted
std::size_t make_copies(const std::vector<PlannedCopy>& copies, const PerturbOptions& options,
                        const PerturbObserver& observer);

}  // namespace mdbd
