#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/options.h"
#include "cli/program.h"
#include "collection/isolated.h"
#include "query/answer_query.h"
#include "query/query_output.h"

namespace {

constexpr const char* examples = R"(Examples:
  mdbd-query chair.ply                      the ten models most like chair.ply
  mdbd-query chair.ply --top 3 --db parts.db
  mdbd-query --id 17 --json                 by a model of the database, for programs
  mdbd-query chair.ply --signature mdbd-fused --explain
                                            by where the balls are, with what makes the difference
  mdbd-query left.stl --chirality           a mirrored part comes after one of the same hand

The answer is exact: no model of the database that is not listed is nearer.
Exit codes: 0 done, 1 failed, 2 wrong usage.)";

constexpr std::size_t explained_differences = 3;

struct Arguments {
  std::filesystem::path model;
  std::filesystem::path database;
  std::int64_t id = 0;
  mdbd::QueryOptions options;
  mdbd::ProcessLimits limits;
  bool is_explained = false;
  bool is_json = false;
  bool is_csv = false;
};

mdbd::QueryAnswer query_by_file(const mdbd::ShapeStore& store, const Arguments& arguments) {
  const auto describe = [&](const std::filesystem::path& file, const mdbd::Recipe& recipe) {
    return mdbd::describe_isolated(file, recipe, arguments.limits);
  };
  return mdbd::query_by_file(store, arguments.model, arguments.options, describe);
}

void print_note(const mdbd::QueryAnswer& answer) {
  const mdbd::SearchResult& result = answer.result;
  if (result.collection_size == 0) {
    fmt::print(stderr, "The database holds no models; add some with mdbd-index.\n");
    return;
  }
  fmt::print(stderr, "Compared with {} model{}; the answer is {}.\n", result.collection_size,
             result.collection_size == 1 ? "" : "s", result.exact ? "exact" : "approximate");
  if (answer.completed > 0) {
    fmt::print(stderr,
               "{} of them had no mdbd-fused in the database; run mdbd-index to store it.\n",
               answer.completed);
  }
}

void print_answer(const mdbd::QueryAnswer& answer, const Arguments& arguments) {
  if (arguments.is_json) {
    fmt::print("{}", mdbd::format_json(answer));
    return;
  }
  fmt::print("{}", arguments.is_csv
                       ? mdbd::format_csv(answer.result)
                       : mdbd::format_table(answer.result, std::filesystem::current_path(),
                                            arguments.is_explained));
  std::fflush(stdout);  // so that the note follows the answer where both go to one place
  print_note(answer);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Finds the models of a database that look most like a given one.", "mdbd-query");
  app.footer(examples);
  Arguments arguments;
  auto* model = app.add_option("MODEL", arguments.model, "A shape file to search with");
  auto* id = app.add_option("--id", arguments.id, "Search with this model of the database instead")
                 ->excludes(model)
                 ->type_name("N");
  app.add_option("--top", arguments.options.count, "How many models to list")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000'000}).description(""))
      ->type_name("N")
      ->capture_default_str();
  mdbd::add_database_option(app, arguments.database);
  mdbd::add_signature_option(app, arguments.options.signature);
  mdbd::add_duration_option(app, "--model-time", arguments.limits.time, "Time budget of MODEL");
  mdbd::add_size_option(app, "--model-memory", arguments.limits.memory, "Memory budget of MODEL");
  app.add_flag("--chirality", arguments.options.has_chirality,
               "Tell left from right: show for each model whether it is of the same hand or "
               "mirrored, and add the difference to the distance");
  auto* explain = app.add_flag("--explain", arguments.is_explained,
                               "Show how much of each distance each part of the signature makes, "
                               "and which of its numbers differ the most");
  auto* json = app.add_flag("--json", arguments.is_json, "Print a JSON object");
  app.add_flag("--csv", arguments.is_csv, "Print CSV")->excludes(json)->excludes(explain);

  return mdbd::run_program(app, argc, argv, [&] {
    if (model->empty() && id->empty()) throw CLI::RequiredError("MODEL or --id");
    const auto store = mdbd::open_store_read_only(arguments.database);
    if (arguments.is_explained) arguments.options.differences = explained_differences;
    print_answer(id->empty() ? query_by_file(*store, arguments)
                             : mdbd::query_by_id(*store, arguments.id, arguments.options),
                 arguments);
    return mdbd::ExitCode::done;
  });
}
