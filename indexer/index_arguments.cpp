#include "indexer/index_arguments.h"

#include <algorithm>
#include <thread>

#include <CLI/CLI.hpp>

#include "cli/number_option.h"
#include "cli/options.h"

namespace mdbd {
namespace {

constexpr const char* examples = R"(Examples:
  mdbd-index models                    add all models below ./models to ./mdbd.db
  mdbd-index models --prune            and remove those whose files are gone
  mdbd-index parts scans --db all.db --jobs 8 --model-time 5m
  mdbd-index models --prune --watch    and stay, following what happens there
  mdbd-index assemblies --per-solid    each solid of a STEP or IGES file is a model
  mdbd-index models --dry-run --json   what would be done, for programs

Unchanged files are passed over, so the same command continues an interrupted run. Hidden files and
links to folders are not followed.
Exit codes: 0 done, 1 failed or interrupted, 2 wrong usage, 3 done, but some models failed.)";

}  // namespace

void declare_options(CLI::App& app, IndexArguments& arguments) {
  const Recipe defaults;
  IndexOptions& options = arguments.options;
  options.jobs = std::max(1U, std::thread::hardware_concurrency());
  app.footer(examples);
  app.add_option("PATH", arguments.paths, "Model files, and folders to search for them")
      ->required()
      ->type_name("");
  add_database_option(app, arguments.database);
  add_number(app, "--jobs", options.jobs, 1, 1024, "Models computed at once")
      ->default_str("processors");
  add_number(app, "--balls", arguments.recipe.balls, 1, 100'000, "Balls of a model")
      ->default_str(std::to_string(defaults.balls));
  add_number(app, "--tolerance", arguments.recipe.radius_tolerance, 1e-9, 0.5,
             "Tolerance of radii, relative")
      ->default_str(CLI::detail::to_string(defaults.radius_tolerance));
  add_denoise_option(app, arguments.recipe.denoise);
  add_solidify_option(app, arguments.recipe.solidify);
  add_unit_option(app, arguments.unit,
                  "Note this unit of length for files whose format has none, such as STL, as they "
                  "are computed; STEP and IGES files tell their own");
  add_duration_option(app, "--model-time", options.limits.time, "Time budget of a model");
  add_size_option(app, "--model-memory", options.limits.memory, "Memory budget of a model");
  app.add_flag("--no-thumbnails", arguments.has_no_thumbnails,
               "Draw no pictures of the models, which mdbd-query --html shows");
  auto* per_solid = app.add_flag_callback(
      "--per-solid", [&options] { options.is_per_solid = true; },
      "Each solid of a STEP or IGES file is a model, part.step#2, from now on in this database");
  app.add_flag_callback(
         "--whole", [&options] { options.is_per_solid = false; },
         "Each STEP or IGES file is one model again")
      ->excludes(per_solid);
  app.add_flag("--force", options.force, "Compute unchanged and failed models again");
  app.add_flag("--prune", options.prune, "Remove models below PATH whose files are gone");
  auto* watch = app.add_flag("--watch", arguments.is_watching,
                             "Stay, and follow what happens at and below PATH until interrupted");
  add_duration_option(app, "--rescan", arguments.rescan,
                      "With --watch, how often to look at everything where the system does not "
                      "report all changes, as on network drives")
      ->needs(watch);
  app.add_flag("--dry-run", arguments.is_dry_run, "Tell what would be done; write nothing")
      ->excludes(watch);
  app.add_flag("--json", arguments.is_json, "Print the summary as a JSON object")->excludes(watch);
  app.add_flag("--quiet", arguments.is_quiet, "Print errors only, and what --json asks for");
}

}  // namespace mdbd
