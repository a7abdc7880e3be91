#include "evaluation/console_progress.h"

#include <fmt/format.h>

#include "cli/terminal.h"

namespace mdbd {

void ConsoleProgress::on_stage(const std::string& stage, std::size_t models) {
  console_.finish();
  console_.print(fmt::format("{}: {} to compute", printable(stage), models));
  console_.start(models);
}

void ConsoleProgress::on_failure(std::string_view stage, std::string_view model,
                                 std::string_view reason) {
  console_.warn(fmt::format("{}{}{}: {}", printable(stage), stage.empty() ? "" : ": ",
                            printable(model), printable(reason)));
}

}  // namespace mdbd
