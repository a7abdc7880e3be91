#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// The declarations of CLI11 as documents tell them.
namespace mdbd {

struct DocumentedOption {
  std::vector<std::string> names;    ///< "-o", "--output"; empty for a positional
  std::string value;                 ///< what stands for its value: "FILE"; empty for a flag
  std::vector<std::string> choices;  ///< of the value, if there are only some
  std::string description;
  std::string default_value;
  std::string environment;  ///< the variable that gives the value, too

  bool has_value() const { return !value.empty(); }
};

struct DocumentedCommand {
  std::string name;
  std::string description;
  std::vector<DocumentedOption> options;      ///< those that --help shows
  std::vector<DocumentedOption> positionals;  ///< their value is how the synopsis shows them
  std::vector<DocumentedCommand> commands;
};

DocumentedCommand list_options(const CLI::App& app);

}  // namespace mdbd
