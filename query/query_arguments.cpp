#include "query/query_arguments.h"

#include <limits>

#include <CLI/CLI.hpp>

#include "cli/number_option.h"
#include "cli/options.h"

namespace mdbd {
namespace {

constexpr const char* examples = R"(Examples:
  mdbd-query chair.ply                      the ten models most like chair.ply
  mdbd-query chair.ply --top 3 --db parts.db
  mdbd-query --id 17 --json                 by a model of the database, for programs
  mdbd-query chair.ply --signature mdbd-fused --explain
                                            by where the balls are, with what makes the difference
  mdbd-query left.stl --chirality           a mirrored part comes after one of the same hand
  mdbd-query bolt.stl --same-size --glob '*.stl'
                                            the ten nearest among STL files of about this size
  mdbd-query new/ --threshold 0.05 --csv    for every model of a folder, all that are near
  mdbd-query chair.ply --explain --html chair.html
                                            a page with pictures, and balls to turn around
  mdbd-query --duplicates                   groups of the same shape, however exported

The answer is exact: no model of the database that passes the filters and is not listed is nearer.
Exit codes: 0 done, 1 failed, 2 wrong usage, 3 done, but some files could not be used.)";

constexpr std::size_t explained_differences = 3;
constexpr double largest = std::numeric_limits<double>::max();

void declare_filters(CLI::App& app, QueryArguments& arguments) {
  CollectionFilter& filter = arguments.options.filter;
  app.add_option("--glob", filter.glob,
                 "Only models whose file name, or path if there is a slash in PATTERN, matches a "
                 "shell pattern; * stands for slashes, too")
      ->type_name("PATTERN");
  app.add_option("--class", filter.label, "Only models that lie in a folder of this name")
      ->type_name("NAME");
  add_number(app, "--min-scale", filter.min_scale, 0.0, largest,
             "Only models whose R, the radius of the smallest enclosing ball in units of the "
             "file, is at least X")
      ->type_name("X");
  add_number(app, "--max-scale", filter.max_scale, 0.0, largest, "Only models whose R is at most X")
      ->type_name("X");
}

void declare_duplicates(CLI::App& app, QueryArguments& arguments) {
  auto* duplicates =
      app.add_flag("--duplicates", arguments.has_duplicates,
                   "Show groups of models of the same shape, rescaled, mirrored, turned, decimated "
                   "or in another format, with the evidence for each; nothing is deleted. Models "
                   "within --threshold, 0.06 if not given, by mdbd-fused and a sixth of that by "
                   "the radii of mdbd-100, and some further apart, are laid upon each other, for "
                   "which their files are read: they are the same if their surfaces deviate by at "
                   "most 0.6 % of R");
  for (const char* other : {"MODEL", "--id", "--top", "--signature", "--chirality", "--explain",
                            "--html", "--same-size", "--unit", "--approx", "--walk-weight"}) {
    duplicates->excludes(app.get_option(other));
  }
  app.add_flag(
         "--no-surfaces", arguments.has_no_surfaces,
         "Read no files, and take all models within --threshold for the same: faster, but near "
         "twins are mixed up, and decimated and scanned copies missed")
      ->needs(duplicates);
}

}  // namespace

void declare_options(CLI::App& app, QueryArguments& arguments) {
  app.footer(examples);
  QueryOptions& options = arguments.options;
  auto* model = app.add_option(
      "MODEL", arguments.models,
      "Shape files or folders of them; part.step#2 is one solid of a STEP or IGES file");
  app.add_option("--id", arguments.id, "Search with this model of the database instead")
      ->excludes(model)
      ->type_name("N");
  app.add_option("--top", options.count, "How many models to list")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000'000}).description(""))
      ->type_name("N")
      ->capture_default_str();
  add_number(app, "--threshold", options.threshold, 0.0, largest,
             "List only models within this distance, and all of them unless --top is given")
      ->type_name("X");
  add_database_option(app, arguments.database);
  app.add_flag(
      "--no-cache", arguments.has_no_cache,
      "Neither read nor write the files DATABASE.*.vectors, from which vectors of large "
      "collections are read faster than from the database; they may be removed at any time");
  add_signature_option(app, options.signature);
  add_number(
      app, "--walk-weight", options.walk_weight, 0.0, 1e6,
      "Weight of the walk sums beside the radii in the distance by mdbd-100, in place of the "
      "database's, 1; less is steadier where meshes are coarse")
      ->type_name("X");
  add_duration_option(app, "--model-time", arguments.limits.time, "Time budget of a MODEL");
  add_size_option(app, "--model-memory", arguments.limits.memory, "Memory budget of a MODEL");
  app.add_flag("--chirality", options.has_chirality,
               "Tell left from right: show for each model whether it is of the same hand or "
               "mirrored, and add the difference to the distance");
  declare_filters(app, arguments);
  add_unit_option(app, options.unit,
                  "Sizes in this unit: those of models whose unit is known, as of STEP files, are "
                  "converted, all others are taken to be in it. Without it sizes are compared as "
                  "they are in the files");
  app.add_flag("--same-size", options.has_same_size,
               "Only models whose R is within 1 % of that of the query");
  app.add_flag("--approx", options.is_approximate,
               "Be content with most of the nearest models, and measure which share of them is "
               "found in this collection; exact answers are faster")
      ->excludes(app.get_option("--threshold"))
      ->excludes(app.get_option("--same-size"));
  auto* explain = app.add_flag("--explain", arguments.is_explained,
                               "Show how much of each distance each part of the signature makes, "
                               "which of its numbers and which balls differ the most, and both "
                               "lists of radii and walk sums");
  app.add_option("--html", arguments.html,
                 "Also write a page with a picture of every model, and the balls of those clicked; "
                 "it needs no network")
      ->type_name("FILE");
  declare_duplicates(app, arguments);
  auto* json = app.add_flag("--json", arguments.is_json,
                            "Print a JSON object, or an array of them for several queries");
  app.add_flag("--csv", arguments.is_csv, "Print CSV")->excludes(json)->excludes(explain);
}

void finish(const CLI::App& app, QueryArguments& arguments) {
  QueryOptions& options = arguments.options;
  const bool has_threshold = app.count("--threshold") > 0;
  if (arguments.has_duplicates) {
    arguments.duplicates.filter = options.filter;
    if (has_threshold) arguments.duplicates.threshold = options.threshold;
    return;
  }
  if (arguments.models.empty() && app.count("--id") == 0) {
    throw CLI::RequiredError("MODEL or --id");
  }
  if (has_threshold && app.count("--top") == 0) {
    options.count = std::numeric_limits<std::size_t>::max();
  }
  if (!arguments.has_no_cache) options.cached_database = arguments.database;
  if (arguments.is_explained) options.differences = explained_differences;
  options.has_data = arguments.is_explained || !arguments.html.empty();
}

}  // namespace mdbd
