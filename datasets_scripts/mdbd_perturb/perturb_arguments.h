#pragma once

#include <filesystem>

#include "datasets_scripts/mdbd_perturb/perturb_models.h"

namespace CLI {
class App;
}

namespace mdbd {

/// The command line of mdbd-perturb.
struct PerturbArguments {
  std::filesystem::path input;
  std::filesystem::path output;
  PerturbOptions options;
  double noise_level = 0.5;  ///< percent of the enclosing ball's diameter
  double distance = 10.0;    ///< diameters of the enclosing ball
  double factor = 25.4;
  bool is_quiet = false;
};

/// Declares the commands of mdbd-perturb, their options and their help.
void declare_commands(CLI::App& app, PerturbArguments& arguments);

}  // namespace mdbd
