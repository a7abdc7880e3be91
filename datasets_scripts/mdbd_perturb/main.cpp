#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/interruption.h"
#include "cli/program.h"
#include "cli/progress_bar.h"
#include "cli/terminal.h"
#include "datasets_scripts/mdbd_perturb/perturb_arguments.h"

namespace {

using mdbd::ExitCode;

constexpr const char* program = "mdbd-perturb";

std::string models(std::size_t count) {
  return fmt::format("{} model{}", count, count == 1 ? "" : "s");
}

ExitCode run(const mdbd::PerturbArguments& arguments) {
  const auto copies =
      mdbd::plan_copies(arguments.input, arguments.output, arguments.options.format);
  mdbd::catch_interruptions();
  mdbd::ProgressBar bar(stderr, !arguments.is_quiet);
  bar.start(copies.size());
  std::size_t failed = 0;
  const auto on_done = [&](const mdbd::PlannedCopy& copy, const mdbd::CopyOutcome& outcome) {
    const bool has_failed = !outcome.problem.empty();
    failed += has_failed ? 1 : 0;
    const std::string& text = has_failed ? outcome.problem : outcome.remark;
    if (has_failed || (!text.empty() && !arguments.is_quiet)) {
      bar.erase();
      mdbd::print_warning(program, mdbd::printable(copy.name) + ": " + mdbd::printable(text));
    }
    bar.advance(has_failed);
  };
  const std::size_t left = mdbd::make_copies(copies, arguments.options,
                                             {.on_done = on_done,
                                              .on_wait = [&] { bar.refresh(); },
                                              .is_interrupted = mdbd::is_interruption_wanted});
  bar.erase();
  const std::size_t made = copies.size() - failed - left;
  if (!arguments.is_quiet) {
    fmt::print("{}: {} written to {}{}\n", arguments.options.perturbation.name, models(made),
               mdbd::printable(arguments.output.string()),
               failed > 0 ? fmt::format(", {} failed", failed) : "");
  }
  if (left > 0) {
    mdbd::print_error(program, fmt::format("interrupted: {} left", models(left)));
    return ExitCode::failed;
  }
  if (made == 0) return ExitCode::failed;
  return failed == 0 ? ExitCode::done : ExitCode::partial;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Makes changed copies of 3D models: noisy, moved, coarser, in another format.",
               program);
  mdbd::PerturbArguments arguments;
  mdbd::declare_commands(app, arguments);
  return mdbd::run_program(app, argc, argv, [&] { return run(arguments); });
}
