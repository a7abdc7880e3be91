#include <filesystem>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/options.h"
#include "cli/program.h"
#include "cli/terminal.h"
#include "db/database_info.h"
#include "db/export_arrays.h"
#include "db/merge_stores.h"
#include "db/verify_store.h"
#include "features/core/signature.h"
#include "features/shape_io/output_file.h"

namespace {

namespace fs = std::filesystem;
using mdbd::ExitCode;

constexpr const char* program = "mdbd-db";

constexpr const char* examples = R"(Examples:
  mdbd-db info                                 what is in ./mdbd.db
  mdbd-db verify --db parts.db                 every page, and every vector from its balls
  mdbd-db backup monday.db                     while others use the database
  mdbd-db compact                              give unused space back
  mdbd-db merge a.db b.db --db all.db          databases of the same recipe, into one
  mdbd-db export vectors vectors.npy           and vectors.models.csv: which row is which model
  mdbd-db export balls balls.csv               id, path, ball, x, y, z, r

Exit codes: 0 done, 1 failed or damaged, 2 wrong usage.)";

struct Arguments {
  fs::path database;
  fs::path target;
  std::vector<fs::path> sources;
  std::string what;
  mdbd::SignatureKind signature = mdbd::SignatureKind::mdbd_100;
};

ExitCode show_info(const Arguments& arguments) {
  const auto store = mdbd::open_store_read_only(arguments.database);
  fmt::print("{}{}", mdbd::describe_database(*store, mdbd::database_size(arguments.database)),
             mdbd::describe_caches(arguments.database));
  return ExitCode::done;
}

ExitCode report(const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) fmt::print("{}\n", mdbd::printable_message(problem));
  return problems.empty() ? ExitCode::done : ExitCode::failed;
}

// Models are read only where SQLite finds nothing wrong: damage may keep them from being read.
ExitCode verify(const Arguments& arguments) {
  if (report(mdbd::find_damage(arguments.database)) != ExitCode::done) return ExitCode::failed;
  const auto store = mdbd::open_store_read_only(arguments.database);
  const mdbd::Verification verification = mdbd::verify_store(*store);
  if (report(verification.problems) != ExitCode::done) return ExitCode::failed;
  fmt::print("{} model{} verified, nothing wrong\n", verification.models,
             verification.models == 1 ? "" : "s");
  return ExitCode::done;
}

ExitCode compact(const Arguments& arguments) {
  const std::uint64_t before = mdbd::database_size(arguments.database).bytes;
  mdbd::compact_database(arguments.database);
  fmt::print("{} before, {} now\n", mdbd::format_size(before),
             mdbd::format_size(mdbd::database_size(arguments.database).bytes));
  return ExitCode::done;
}

ExitCode merge(const Arguments& arguments) {
  std::unique_ptr<mdbd::ShapeStore> target;
  for (const fs::path& path : arguments.sources) {
    const auto source = mdbd::open_store_read_only(path);
    if (!target) target = mdbd::open_store(arguments.database, source->recipe());
    const mdbd::MergeSummary summary = mdbd::merge_store(*source, *target);
    fmt::print("{}: {} added, {} replaced, {} kept\n", mdbd::printable(path.string()),
               summary.added, summary.replaced, summary.kept);
  }
  return ExitCode::done;
}

void write_vectors(const mdbd::ShapeStore& store, const Arguments& arguments, bool is_npy) {
  // Read once: the rows of both files are those of one state of the database.
  const auto vectors = store.vectors(mdbd::stored_name(arguments.signature));
  if (!is_npy) {
    mdbd::write_file(arguments.target, mdbd::vectors_to_csv(vectors));
    return;
  }
  mdbd::write_file(arguments.target, mdbd::vectors_to_npy(vectors));
  mdbd::write_file(fs::path(arguments.target).replace_extension(".models.csv"),
                   mdbd::models_to_csv(vectors));
}

ExitCode export_numbers(const Arguments& arguments) {
  const fs::path ending = arguments.target.extension();
  if (ending != ".npy" && ending != ".csv") {
    throw CLI::ValidationError(arguments.target.string(), "the ending must be .npy or .csv");
  }
  const auto store = mdbd::open_store_read_only(arguments.database);
  if (arguments.what == "vectors") {
    write_vectors(*store, arguments, ending == ".npy");
  } else {
    mdbd::write_file(arguments.target,
                     ending == ".npy" ? mdbd::balls_to_npy(*store) : mdbd::balls_to_csv(*store));
  }
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Looks after a database of models.", program);
  Arguments arguments;
  app.footer(examples);
  app.fallthrough();
  app.require_subcommand(1);
  mdbd::add_database_option(app, arguments.database);
  const auto* info = app.add_subcommand("info", "Show what is in it");
  const auto* verification = app.add_subcommand(
      "verify", "Check every page, and both signatures of every model against its balls");
  auto* backup = app.add_subcommand("backup", "Copy it to a new file while it is in use");
  backup->add_option("FILE", arguments.target, "The copy")->required();
  const auto* compaction = app.add_subcommand("compact", "Give unused space back");
  auto* merging = app.add_subcommand("merge", "Take over the models of databases of its recipe");
  merging->add_option("SOURCE", arguments.sources, "Databases")->required();
  auto* exporting = app.add_subcommand("export", "Write vectors or balls as NumPy array or CSV");
  exporting->add_option("WHAT", arguments.what, "vectors or balls")
      ->required()
      ->check(CLI::IsMember({"vectors", "balls"}).description(""));
  exporting->add_option("FILE", arguments.target, "FILE.npy or FILE.csv")->required();
  mdbd::add_signature_option(*exporting, arguments.signature);

  return mdbd::run_program(app, argc, argv, [&] {
    if (info->parsed()) return show_info(arguments);
    if (verification->parsed()) return verify(arguments);
    if (compaction->parsed()) return compact(arguments);
    if (merging->parsed()) return merge(arguments);
    if (exporting->parsed()) return export_numbers(arguments);
    mdbd::backup_database(arguments.database, arguments.target);
    return ExitCode::done;
  });
}
