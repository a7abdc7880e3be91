#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/comparison.h"
#include "bench/comparison_report.h"
#include "bench/shared_models.h"
#include "cli/program.h"
#include "cli/progress_bar.h"
#include "cli/terminal.h"
#include "features/core/errors.h"
#include "features/shape_io/read_mesh.h"
#include "report/format_report.h"

namespace {

using namespace mdbd;

constexpr const char* program = "bench_compare";

struct Arguments {
  std::string set = "lpsb";
  std::size_t stride = 1;
  DecompositionOptions options;
  bool is_json = false;
};

// Compares the methods on a model unless they are made for another kind.
bool add_comparison(const std::filesystem::path& path, const DecompositionOptions& options,
                    std::vector<bench::ModelComparison>& comparisons) {
  try {
    const MeshFile file = read_mesh(path);
    if (!file.statistics.watertight || file.statistics.orientation == Orientation::mixed) {
      return false;
    }
    const std::string name = (path.parent_path().filename() / path.filename()).string();
    comparisons.push_back(bench::compare_methods(name, file.mesh, options));
  } catch (const InvalidInput& error) {
    print_warning(program, fmt::format("{}: {}", path.string(), error.what()));
    return false;
  }
  return true;
}

Report compare(const std::vector<std::filesystem::path>& paths, const Arguments& arguments) {
  std::vector<bench::ModelComparison> comparisons;
  ProgressBar bar(stderr);
  bar.start(paths.size());
  for (const std::filesystem::path& path : paths) {
    bar.advance(!add_comparison(path, arguments.options, comparisons));
    bar.refresh();
  }
  bar.erase();
  if (comparisons.empty()) throw InvalidInput("none of the models is closed");
  Report report =
      bench::make_comparison_report(fmt::format("{} balls at {}, set {}", arguments.options.balls,
                                                arguments.options.radius_tolerance, arguments.set),
                                    comparisons);
  if (const std::size_t left = paths.size() - comparisons.size(); left > 0) {
    report.notes.push_back(fmt::format("{} models are left out: not closed or unusable.", left));
  }
  return report;
}

ExitCode run(const Arguments& arguments) {
  const auto paths = bench::find_shared_models(arguments.set, arguments.stride);
  if (paths.empty()) {
    print_warning(program, fmt::format("skipped: no models in {}; set MDBD_DATA to their folder",
                                       (bench::shared_data_folder() / arguments.set).string()));
    return ExitCode::done;
  }
  const Report report = compare(paths, arguments);
  const bool is_json = arguments.is_json;
  fmt::print("{}", is_json ? format_report_json(report)
                           : format_report_text(report, terminal_width(stdout)));
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares decompositions with those from a distance transform, on shared models.",
               program);
  Arguments arguments;
  app.add_option("--set", arguments.set, "A folder below $MDBD_DATA")->capture_default_str();
  app.add_option("--stride", arguments.stride, "Take every N-th model")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--balls", arguments.options.balls, "How many balls")->capture_default_str();
  app.add_option("--tolerance", arguments.options.radius_tolerance, "Of the certified radii")
      ->capture_default_str();
  app.add_flag("--json", arguments.is_json, "Every number of every model");
  return run_program(app, argc, argv, [&] { return run(arguments); });
}
