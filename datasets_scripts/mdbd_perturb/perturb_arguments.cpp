#include "datasets_scripts/mdbd_perturb/perturb_arguments.h"

#include <algorithm>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/options.h"
#include "features/shape_io/write_mesh.h"

namespace mdbd {
namespace {

constexpr const char* examples = R"(Examples:
  mdbd-perturb noise --level 0.5 models noisy      a noisy copy of every model below ./models
  mdbd-perturb decimate --keep 10 chair.obj coarse.off
  mdbd-perturb convert --format stl models stl     the same models in another format
  mdbd-perturb rotate --seed 7 models rotated

OUT of a folder is a folder of the same structure; OUT of a file is a file or an existing folder.
A copy depends on the model's content and the seed only: it is the one that mdbd-evaluate measures.
Exit codes: 0 done, 1 failed or interrupted, 2 wrong usage, 3 done, but some models failed.)";

constexpr const char* common_options = "Options of every command";

CLI::App* add_command(CLI::App& app, PerturbArguments& arguments, const char* name,
                      const char* description, const std::function<Perturbation()>& make) {
  CLI::App* command = app.add_subcommand(name, description);
  command->fallthrough();
  command->callback([&arguments, make] { arguments.options.perturbation = make(); });
  command->add_option("IN", arguments.input, "A model file, or a folder of them")
      ->required()
      ->type_name("");
  command->add_option("OUT", arguments.output, "Where the copy or the copies go")
      ->required()
      ->type_name("");
  if (make().is_random) {
    command->add_option("--seed", arguments.options.seed, "Seed of what is random")
        ->type_name("N")
        ->capture_default_str();
  }
  return command;
}

CLI::Option* add_number(CLI::App* command, const char* name, double& number, double lowest,
                        double highest, const char* description) {
  return command->add_option(name, number, description)
      ->check(CLI::Range(lowest, highest).description(""))
      ->type_name("N")
      ->capture_default_str();
}

void add_numbered_commands(CLI::App& app, PerturbArguments& arguments) {
  add_number(add_command(app, arguments, "noise", "Move every vertex by a random vector",
                         [&] { return noise_perturbation(arguments.noise_level); }),
             "--level", arguments.noise_level, 0, 100,
             "Length that no vector exceeds, in percent of the enclosing ball's diameter");
  add_number(add_command(app, arguments, "decimate", "Collapse edges until fewer faces are left",
                         [&] { return decimation_perturbation(arguments.options.wanted_faces); }),
             "--keep", arguments.options.wanted_faces, 1e-3, 100, "Faces to keep, in percent")
      ->required()
      ->default_str("");
  add_number(add_command(app, arguments, "translate", "Move in a random direction",
                         [&] { return translation_perturbation(arguments.distance); }),
             "--distance", arguments.distance, 0, 1e6, "In diameters of the enclosing ball");
  add_number(add_command(app, arguments, "scale", "Multiply all coordinates by a factor",
                         [&] { return scale_perturbation(arguments.factor); }),
             "--factor", arguments.factor, 1e-6, 1e6, "The factor");
}

void add_common_options(CLI::App& app, PerturbArguments& arguments) {
  PerturbOptions& options = arguments.options;
  options.jobs = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::string> formats;
  for (const std::string_view extension : written_mesh_extensions()) {
    formats.emplace_back(extension.substr(1));
  }
  app.add_option("--format", options.format, "Format of the copies; else that of the models")
      ->transform(CLI::IsMember(formats, CLI::ignore_case).description(""))
      ->type_name("off|obj|ply|stl")
      ->group(common_options);
  app.add_option("--jobs", options.jobs, "Models changed at once")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N")
      ->default_str("processors")
      ->group(common_options);
  add_duration_option(app, "--model-time", options.limits.time, "Time budget of a model")
      ->group(common_options);
  add_size_option(app, "--model-memory", options.limits.memory, "Memory budget of a model")
      ->group(common_options);
  app.add_flag("--quiet", arguments.is_quiet, "Print errors only")->group(common_options);
}

}  // namespace

void declare_commands(CLI::App& app, PerturbArguments& arguments) {
  app.footer(examples);
  app.require_subcommand(1);
  add_common_options(app, arguments);
  add_numbered_commands(app, arguments);
  add_command(app, arguments, "rotate", "Rotate at random", rotation_perturbation);
  add_command(app, arguments, "mirror", "Reflect at a random plane", mirror_perturbation);
  add_command(app, arguments, "subdivide", "Cut every face into four", subdivision_perturbation);
  add_command(app, arguments, "shuffle", "Put vertices and faces in a random order",
              shuffling_perturbation);
  add_command(app, arguments, "convert", "Change nothing but the format", [] {
    return Perturbation{.name = "conversion",
                        .apply = [](const TriangleMesh& mesh, std::uint64_t) { return mesh; }};
  });
}

}  // namespace mdbd
