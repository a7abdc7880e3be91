#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/options.h"
#include "cli/program.h"
#include "cli/terminal.h"
#include "decompose/isolated_decomposition.h"
#include "features/core/errors.h"
#include "features/shape_io/output_file.h"

namespace {

constexpr const char* examples = R"(Examples:
  mdbd-decompose part.stl                      x,y,z,r of 500 balls on standard output
  mdbd-decompose part.stl -o part.csv          into a file
  mdbd-decompose part.stl -o part.json         with contacts and certificate
  mdbd-decompose plate.svg -o discs.svg        a drawing of a domain in the plane and its discs
  mdbd-decompose part.stl --balls 50 --tolerance 0.01

Coordinates and radii are in the units of the file.
Exit codes: 0 done, 1 failed, 2 wrong usage.)";

// What is wrong with --balls or --tolerance is for validate() to say.
void require_valid(const mdbd::Recipe& recipe) {
  try {
    mdbd::validate(recipe);
  } catch (const mdbd::InvalidInput& error) {
    throw CLI::ValidationError(error.what());
  }
}

mdbd::BallFormat require_format(const std::filesystem::path& output) {
  const auto format = mdbd::ball_format_of(output);
  if (!format) {
    throw CLI::ValidationError(
        "--output",
        fmt::format("{}: the ending must be .csv, .xyzr, .json or .svg", output.string()));
  }
  return *format;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Decomposes a solid, or a domain in the plane, into its largest disjoint balls.",
               "mdbd-decompose");
  app.footer(examples);
  std::filesystem::path model;
  std::filesystem::path output;
  mdbd::Recipe recipe;
  app.add_option("MODEL", model, "A shape file, or one solid of a STEP or IGES file: part.step#2")
      ->required();
  app.add_option("-o,--output", output, "Write to this file; its ending gives the format")
      ->type_name("FILE");
  app.add_option("--balls", recipe.balls, "How many balls are placed at most")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--tolerance", recipe.radius_tolerance,
                 "How far a ball's radius may be below the largest possible, relative to it")
      ->type_name("RATIO")
      ->capture_default_str();
  std::optional<std::string> denoise;
  mdbd::add_denoise_option(app, denoise);
  std::optional<std::string> solidify;
  mdbd::add_solidify_option(app, solidify);
  mdbd::ProcessLimits limits;
  mdbd::add_duration_option(app, "--model-time", limits.time, "Time budget of the model");
  mdbd::add_size_option(app, "--model-memory", limits.memory, "Memory budget of the model");

  return mdbd::run_program(app, argc, argv, [&] {
    recipe.denoise = denoise.value_or(recipe.denoise);
    recipe.solidify = solidify.value_or(recipe.solidify);
    require_valid(recipe);
    const auto format = output.empty() ? mdbd::BallFormat::csv : require_format(output);
    const auto [text, shortage] = mdbd::decompose_isolated(model, recipe, format, limits);
    if (output.empty()) {
      fmt::print("{}", text);
    } else {
      mdbd::write_file(output, text);
    }
    if (!shortage.empty()) {
      fmt::print(stderr, "{}: {}\n", mdbd::printable(model.string()), shortage);
    }
    return mdbd::ExitCode::done;
  });
}
