#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cli/progress_bar.h"

namespace mdbd {

/// Shows a long run on standard error, and ends it at SIGINT or SIGTERM; a second one, half a
/// second later or more, has its default effect. Only one may exist.
class RunConsole {
 public:
  /// @param program its name, for messages
  RunConsole(std::string program, bool is_quiet);

  /// Begins a stage of so many models.
  void start(std::size_t models) { bar_.start(models); }
  /// Adds so many models to the stage.
  void extend(std::size_t models) { bar_.extend(models); }
  void advance(bool has_failed) { bar_.advance(has_failed); }
  /// Call it about ten times a second.
  void refresh() { bar_.refresh(); }
  /// Takes the progress bar off the terminal.
  void finish() { bar_.erase(); }

  /// Writes a line; nothing if quiet.
  void print(std::string_view line);
  /// Writes a warning that is safe to show; nothing if quiet.
  void warn(std::string_view message);

  /// Whether the run is to end; says so once.
  bool is_interrupted();

 private:
  std::string program_;
  bool is_quiet_;
  bool has_announced_end_ = false;
  ProgressBar bar_;
};

}  // namespace mdbd
