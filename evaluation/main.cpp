#include <span>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/program.h"
#include "cli/terminal.h"
#include "evaluation/console_progress.h"
#include "evaluation/evaluate_arguments.h"
#include "evaluation/finish_report.h"
#include "report/format_report.h"

namespace {

using mdbd::ExitCode;

constexpr const char* program = "mdbd-evaluate";

void print_report(const mdbd::Report& report, const mdbd::EvaluateArguments& arguments) {
  if (arguments.outputs.is_json_printed()) {
    fmt::print("{}", mdbd::format_report_json(report));
  } else if (!arguments.is_quiet) {
    fmt::print("{}", mdbd::format_report_text(report, mdbd::terminal_width(stdout)));
  }
}

ExitCode run(const mdbd::EvaluateArguments& arguments, const std::string& command) {
  mdbd::require_writable(arguments.outputs);
  const mdbd::LabelledCollection collection =
      mdbd::find_labelled_models(arguments.collection, arguments.sample_size, arguments.seed);
  mdbd::RunConsole console(program, arguments.is_quiet);
  mdbd::ConsoleProgress progress(console);
  mdbd::ModelCache cache(arguments.cache, arguments.recipe, progress);
  const mdbd::EvaluationInput input{collection, cache, arguments.seed, arguments.signature};
  mdbd::Report report = arguments.make_report(input);
  console.finish();
  mdbd::finish_report(report, input, {command, std::string(mdbd::version())});
  mdbd::write_outputs(report, arguments.outputs);
  print_report(report, arguments);
  return mdbd::has_failures(input) ? ExitCode::partial : ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Reports how far answers to searches by shape can be trusted.", program);
  mdbd::EvaluateArguments arguments;
  mdbd::declare_commands(app, arguments);
  const std::string command = mdbd::join_command(std::span(argv, static_cast<std::size_t>(argc)));
  return mdbd::run_program(app, argc, argv, [&] { return run(arguments, command); });
}
