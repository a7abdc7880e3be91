#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/interruption.h"
#include "cli/program.h"
#include "features/brep/solid_path.h"
#include "features/core/errors.h"
#include "features/shape_unit.h"
#include "indexer/change_printer.h"
#include "indexer/console_observer.h"
#include "indexer/index_arguments.h"
#include "indexer/index_report.h"
#include "indexer/watch_index.h"

namespace {

using mdbd::ExitCode;

constexpr const char* program = "mdbd-index";

ExitCode report(const mdbd::IndexSummary& summary, const mdbd::IndexArguments& arguments) {
  const bool is_dry_run = arguments.is_dry_run;
  if (!arguments.is_quiet) fmt::print(stderr, "{}", mdbd::format_old_failures(summary));
  if (arguments.is_json) {
    fmt::print("{}", mdbd::format_index_json(summary, arguments.database, is_dry_run));
  } else if (!arguments.is_quiet) {
    fmt::print("{}", mdbd::format_index_text(summary, arguments.database, is_dry_run));
  }
  if (summary.is_interrupted) {
    mdbd::print_error(program,
                      fmt::format("interrupted: {} model{} left; run the same command to continue",
                                  summary.left, summary.left == 1 ? "" : "s"));
    return ExitCode::failed;
  }
  return summary.failures.empty() ? ExitCode::done : ExitCode::partial;
}

void require_files(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (mdbd::split_solid_path(path).solid == 0) continue;
    throw mdbd::InvalidInput(path + ": is one solid; name its file, with --per-solid");
  }
}

ExitCode run(const mdbd::IndexArguments& arguments) {
  mdbd::RunConsole console(program, arguments.is_quiet);
  mdbd::ConsoleObserver observer(console);
  // The search comes first: a mistyped path must not leave an empty database behind.
  const mdbd::Discovery found = mdbd::discover(arguments.paths);
  require_files(found.roots);
  const auto store =
      mdbd::open_index_store(arguments.database, arguments.recipe, arguments.is_dry_run);
  const mdbd::DescribeFunction describe = [&](const std::filesystem::path& path) {
    if (arguments.is_dry_run) return mdbd::ShapeDescription{};
    mdbd::ShapeDescription description = arguments.has_no_thumbnails
                                             ? mdbd::describe_file(path, store->recipe())
                                             : mdbd::describe_with_thumbnail(path, store->recipe());
    if (!arguments.unit.empty()) {
      description.statistics = mdbd::declare_unit(description.statistics, arguments.unit);
    }
    return description;
  };
  if (arguments.is_watching) {
    mdbd::ChangePrinter printer(console, arguments.is_quiet);
    mdbd::watch_index(found.roots, arguments.options, describe, *store, printer,
                      {.rescan = arguments.rescan, .is_ended = mdbd::is_interruption_wanted});
    return ExitCode::done;
  }
  const auto summary = mdbd::run_index(found, arguments.options, describe, *store, observer);
  console.finish();
  return report(summary, arguments);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Indexes 3D models for search by shape.", program);
  mdbd::IndexArguments arguments;
  mdbd::declare_options(app, arguments);
  return mdbd::run_program(app, argc, argv, [&] { return run(arguments); });
}
