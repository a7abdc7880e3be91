#include <cstdio>
#include <span>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/program.h"
#include "cli/progress_bar.h"
#include "features/shape_io/output_file.h"
#include "query/compare_surfaces.h"
#include "query/duplicates_output.h"
#include "query/query_arguments.h"
#include "query/query_output.h"
#include "query/query_page.h"
#include "query/run_queries.h"

namespace {

using mdbd::ExitCode;

constexpr const char* program = "mdbd-query";

void print_completed(std::size_t completed) {
  if (completed == 0) return;
  fmt::print(stderr, "{} of them had no mdbd-fused in the database; run mdbd-index to store it.\n",
             completed);
}

void print_note(const mdbd::QueryAnswer& answer, bool is_filtered) {
  const mdbd::SearchResult& result = answer.result;
  if (result.compared == 0) {
    fmt::print(stderr, "{}\n",
               is_filtered ? "No model of the database passes the filters."
                           : "The database holds no models; add some with mdbd-index.");
    return;
  }
  fmt::print(stderr, "Compared with {} model{}; {}.\n", result.compared,
             result.compared == 1 ? "" : "s", mdbd::describe_exactness(answer));
  print_completed(answer.completed);
}

mdbd::DuplicateReport search_duplicates(const mdbd::ShapeStore& store,
                                        const mdbd::QueryArguments& arguments) {
  mdbd::DuplicateOptions options = arguments.duplicates;
  mdbd::ProgressBar progress(stderr);
  if (!arguments.has_no_surfaces) {
    options.compare_surfaces = [&](std::span<const mdbd::ModelPair> pairs) {
      return mdbd::compare_surfaces(store, pairs, arguments.limits, progress);
    };
  }
  return mdbd::find_duplicates(store, options);
}

void print_measured(const mdbd::DuplicateReport& report) {
  if (report.measured > 0) {
    fmt::print(stderr, "Surfaces of {} doubtful pair{} were compared.\n", report.measured,
               report.measured == 1 ? "" : "s");
  }
  if (report.not_measured > 0) {
    fmt::print(stderr,
               "Surfaces of {} doubtful pair{} could not be compared: files are gone, have changed "
               "or cannot be read.\n",
               report.not_measured, report.not_measured == 1 ? "" : "s");
  }
}

ExitCode find_duplicates(const mdbd::ShapeStore& store, const mdbd::QueryArguments& arguments) {
  const mdbd::DuplicateReport report = search_duplicates(store, arguments);
  if (arguments.is_json) {
    fmt::print("{}", mdbd::format_duplicates_json(report, arguments.duplicates.threshold));
    return ExitCode::done;
  }
  fmt::print("{}", arguments.is_csv
                       ? mdbd::format_duplicates_csv(report)
                       : mdbd::format_duplicates_table(report, std::filesystem::current_path()));
  std::fflush(stdout);
  fmt::print(stderr, "{} group{} of the same shape among {} model{}.\n", report.groups.size(),
             report.groups.size() == 1 ? "" : "s", report.compared,
             report.compared == 1 ? "" : "s");
  print_measured(report);
  print_completed(report.completed);
  return ExitCode::done;
}

ExitCode find_matches(const mdbd::ShapeStore& store, const mdbd::QueryArguments& arguments) {
  const mdbd::QueryRun run = mdbd::run_queries(store, arguments);
  fmt::print("{}", mdbd::format_answers(run, arguments, std::filesystem::current_path()));
  std::fflush(stdout);  // so that the note follows the answer where both go to one place
  if (!arguments.html.empty()) {
    mdbd::write_file(
        arguments.html,
        mdbd::format_query_page(run.answers, {.signature = to_string(arguments.options.signature),
                                              .is_explained = arguments.is_explained}));
  }
  for (const std::string& failure : run.failures) mdbd::print_warning(program, failure);
  if (!arguments.is_json && !run.answers.empty()) {
    const mdbd::QueryOptions& options = arguments.options;
    print_note(run.answers.front(), !options.filter.is_empty() || options.has_same_size);
  }
  if (run.failures.empty()) return ExitCode::done;
  return run.answers.empty() ? ExitCode::failed : ExitCode::partial;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Finds the models of a database that look most like given ones.", program);
  mdbd::QueryArguments arguments;
  mdbd::declare_options(app, arguments);
  return mdbd::run_program(app, argc, argv, [&] {
    mdbd::finish(app, arguments);
    const auto store = mdbd::open_store_read_only(arguments.database);
    return arguments.has_duplicates ? find_duplicates(*store, arguments)
                                    : find_matches(*store, arguments);
  });
}
