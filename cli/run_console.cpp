#include "cli/run_console.h"

#include <utility>

#include "cli/interruption.h"
#include "cli/program.h"

namespace mdbd {

RunConsole::RunConsole(std::string program, bool is_quiet)
    : program_(std::move(program)), is_quiet_(is_quiet), bar_(stderr, !is_quiet) {
  catch_interruptions();
}

void RunConsole::print(std::string_view line) {
  if (!is_quiet_) bar_.print_above(line);
}

void RunConsole::warn(std::string_view message) {
  if (is_quiet_) return;
  bar_.erase();
  print_warning(program_, message);
  bar_.refresh();
}

bool RunConsole::is_interrupted() {
  if (!is_interruption_wanted()) return false;
  if (!has_announced_end_) print("Finishing the models in flight; once more to stop at once.");
  has_announced_end_ = true;
  return true;
}

}  // namespace mdbd
