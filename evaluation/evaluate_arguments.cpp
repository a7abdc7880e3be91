#include "evaluation/evaluate_arguments.h"

#include <algorithm>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>

#include "cli/number_option.h"
#include "cli/options.h"

namespace mdbd {
namespace {

constexpr const char* examples = R"(Examples:
  mdbd-evaluate retrieval models --html retrieval.html
  mdbd-evaluate noise models --levels 0.5,1,2 --signature mdbd-fused --json noise.json
  mdbd-evaluate classify models --sample 50 --seed 7
  mdbd-evaluate retrieval --help            the options of a command

A collection is a folder with one folder for each class: models/chair/1.off. What is computed is kept
in ./mdbd-cache, so that the same command continues an interrupted run and further reports on the
same models begin at once. The folder may be deleted at any time.
Exit codes: 0 done, 1 failed or interrupted, 2 wrong usage, 3 done, but some models failed.)";

/// The same options for every command.
void add_common_options(CLI::App& app, EvaluateArguments& arguments, const Recipe& defaults) {
  app.add_option("COLLECTION", arguments.collection, "A folder with one folder for each class")
      ->required()
      ->type_name("");
  auto* json = app.add_option("--json", arguments.outputs.json,
                              "Write all numbers to this file; - for standard output");
  json->type_name("FILE");
  app.add_option("--html", arguments.outputs.html, "Write the report as a page to this file")
      ->type_name("FILE");
  add_number(app, "--sample", arguments.sample_size, 1, 1'000'000'000,
             "Take at most so many models of each class, drawn at random");
  app.add_option("--seed", arguments.seed, "Everything random depends on it")
      ->type_name("N")
      ->capture_default_str();
  add_signature_option(app, arguments.signature);
  add_number(app, "--balls", arguments.balls, 1, 100'000, "Balls of a model")
      ->default_str(std::to_string(defaults.balls));
  add_number(app, "--walk-weight", arguments.walk_weight, 0.0, 1e6,
             "Weight of the walk sums beside the radii in the distance by mdbd-100")
      ->type_name("X")
      ->default_str(CLI::detail::to_string(defaults.walk_weight));
  add_denoise_option(app, arguments.denoise);
  add_solidify_option(app, arguments.solidify);
  add_number(app, "--jobs", arguments.cache.jobs, 1, 1024, "Models computed at once")
      ->default_str("processors");
  app.add_option("--cache", arguments.cache.folder, "Keep what is computed in this folder")
      ->type_name("DIR")
      ->capture_default_str();
  add_duration_option(app, "--model-time", arguments.cache.limits.time, "Time budget of a model");
  add_size_option(app, "--model-memory", arguments.cache.limits.memory, "Memory budget of a model");
  app.add_flag("--quiet", arguments.is_quiet, "Print errors only, and what --json - asks for");
}

/// Adds a command with the common options.
/// @param make makes its report with the command's own options
template <typename Make>
CLI::App* add_command(CLI::App& app, EvaluateArguments& arguments, const char* name,
                      const char* description, const Recipe& defaults, Make make) {
  CLI::App* command = app.add_subcommand(name, description)->group("Commands");
  add_common_options(*command, arguments, defaults);
  command->callback([&arguments, defaults, make] {
    if (!arguments.outputs.html.empty() && arguments.outputs.html == arguments.outputs.json) {
      throw CLI::ValidationError("--html", "the file is that of --json");
    }
    arguments.recipe = defaults;
    arguments.recipe.balls = arguments.balls.value_or(defaults.balls);
    arguments.recipe.walk_weight = arguments.walk_weight.value_or(defaults.walk_weight);
    arguments.recipe.denoise = arguments.denoise.value_or(defaults.denoise);
    arguments.recipe.solidify = arguments.solidify.value_or(defaults.solidify);
    arguments.make_report = make;
  });
  return command;
}

void add_retrieval(CLI::App& app, EvaluateArguments& arguments) {
  CLI::App* command = add_command(app, arguments, "retrieval",
                                  "How well models of the same class are found, beside rivals", {},
                                  [&](const EvaluationInput& input) {
                                    return make_retrieval_report(input, arguments.retrieval);
                                  });
  command->add_flag_callback(
      "--no-rivals", [&] { arguments.retrieval.has_rivals = false; },
      "Leave out the rivals ESF, GASD, D2 and SH of distances");
  add_number(*command, "--confusions", arguments.retrieval.confusions, 0, 1'000'000,
             "List so many of the worst confusions")
      ->capture_default_str();
}

/// Takes the sign from "0.5%".
std::string strip_percent(std::string& level) {
  if (level.ends_with('%')) level.pop_back();
  return "";
}

void add_worst(CLI::App& command, std::size_t& worst) {
  add_number(command, "--worst", worst, 0, 1'000'000,
             "List so many of the models that moved the furthest")
      ->capture_default_str();
}

void add_noise(CLI::App& app, EvaluateArguments& arguments) {
  CLI::App* command = add_command(
      app, arguments, "noise", "How far noise on the surface changes the answers", {},
      [&](const EvaluationInput& input) { return make_noise_report(input, arguments.noise); });
  command
      ->add_option("--levels", arguments.noise.levels,
                   "Bounds of the noise in percent of a model's diameter: 0.5,1 or 0.5%,1%")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(CLI::Validator(strip_percent, ""))
      ->check(CLI::Range(0.0, 100.0).description(""))
      ->type_name("LIST")
      ->default_str("0.5,1");
  command
      ->add_option("--query", arguments.noise.queries,
                   "Draw the distances of this model, named as chair/1.off; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME");
  add_worst(*command, arguments.noise.worst);
}

void add_invariance(CLI::App& app, EvaluateArguments& arguments) {
  CLI::App* command = add_command(app, arguments, "invariance",
                                  "How far the answers change under what should not change them",
                                  {}, [&](const EvaluationInput& input) {
                                    return make_invariance_report(input, arguments.invariance);
                                  });
  add_worst(*command, arguments.invariance.worst);
}

void add_representations(CLI::App& app, EvaluateArguments& arguments) {
  CLI::App* command = add_command(
      app, arguments, "representations", "How well models are found by point clouds of themselves",
      {}, [&](const EvaluationInput& input) {
        return make_representations_report(input, arguments.representations);
      });
  RepresentationsOptions& options = arguments.representations;
  command->add_option("--points", options.points, "Points of the clouds: 5000,20000")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(std::size_t{100}, std::size_t{10'000'000}).description(""))
      ->type_name("LIST")
      ->default_str("5000,20000,100000");
  add_number(*command, "--noisy-points", options.noisy_points, 100, 10'000'000,
             "Points of the clouds with noise")
      ->capture_default_str();
  add_number(*command, "--noise", options.noise, 0.0, 100.0,
             "Bound of the noise in percent of a model's diameter")
      ->capture_default_str();
  add_worst(*command, options.worst);
}

/// With the number of balls of the paper's section 5.3.
Recipe classify_recipe() {
  Recipe recipe;
  recipe.balls = 800;
  return recipe;
}

void add_classify(CLI::App& app, EvaluateArguments& arguments) {
  CLI::App* command =
      add_command(app, arguments, "classify", "How well a small neural network learns the classes",
                  classify_recipe(), [&](const EvaluationInput& input) {
                    return make_classify_report(input, arguments.classify);
                  });
  ClassifierOptions& network = arguments.classify.network;
  add_number(*command, "--runs", arguments.classify.runs, 1, 10'000,
             "Random divisions into training, validation and test")
      ->capture_default_str();
  add_number(*command, "--hidden", network.hidden_neurons, 1, 100'000, "Hidden neurons")
      ->capture_default_str();
  add_number(*command, "--learning-rate", network.learning_rate, 1e-9, 1.0, "Of Adam")
      ->capture_default_str();
  add_number(*command, "--weight-decay", network.weight_decay, 0.0, 1.0, "Of Adam")
      ->capture_default_str();
  add_number(*command, "--batch", network.batch_size, 1, 1'000'000, "Models of one step")
      ->capture_default_str();
  add_number(*command, "--epochs", network.maximum_epochs, 1, 1'000'000, "At most so many epochs")
      ->capture_default_str();
  add_number(*command, "--patience", network.patience, 1, 1'000'000,
             "Stop after so many epochs without progress")
      ->capture_default_str();
}

void add_certificate(CLI::App& app, EvaluateArguments& arguments) {
  CLI::App* command =
      add_command(app, arguments, "certificate",
                  "Whether balls are contained, disjoint and maximal, checked again in another way",
                  {}, [&](const EvaluationInput& input) {
                    return make_certificate_report(input, arguments.certificate);
                  });
  RecheckOptions& search = arguments.certificate.search;
  add_number(*command, "--samples", search.samples, 1, 100'000'000,
             "Points of a model where larger balls are looked for")
      ->capture_default_str();
  add_number(*command, "--climbs", search.climbs, 1, 100'000'000,
             "How many of them climb when a ball is re-checked")
      ->capture_default_str();
  add_number(*command, "--worst", arguments.certificate.worst, 0, 1'000'000,
             "List so many models of each kind of violation")
      ->capture_default_str();
}

}  // namespace

void declare_commands(CLI::App& app, EvaluateArguments& arguments) {
  arguments.cache.folder = "mdbd-cache";
  arguments.cache.jobs = std::max(1U, std::thread::hardware_concurrency());
  app.footer(examples);
  app.require_subcommand(1);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  add_retrieval(app, arguments);
  add_noise(app, arguments);
  add_invariance(app, arguments);
  add_representations(app, arguments);
  add_classify(app, arguments);
  add_certificate(app, arguments);
}

}  // namespace mdbd
