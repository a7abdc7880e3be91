#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "evaluation/evaluation_input.h"
#include "evaluation/reports/certificate_report.h"
#include "evaluation/reports/classify_report.h"
#include "evaluation/reports/invariance_report.h"
#include "evaluation/reports/noise_report.h"
#include "evaluation/reports/representations_report.h"
#include "evaluation/reports/retrieval_report.h"
#include "evaluation/write_outputs.h"
#include "report/report.h"

namespace CLI {
class App;
}

namespace mdbd {

/// The command line of mdbd-evaluate.
struct EvaluateArguments {
  std::filesystem::path collection;
  ReportOutputs outputs;
  std::uint64_t seed = 1;
  std::size_t sample_size = 0;  ///< models of each class; 0 takes all
  std::optional<int> balls;
  std::optional<double> walk_weight;
  std::optional<std::string> denoise;
  std::optional<std::string> solidify;
  CacheOptions cache;
  SignatureKind signature = SignatureKind::mdbd_100;
  bool is_quiet = false;

  RetrievalOptions retrieval;
  NoiseOptions noise;
  InvarianceOptions invariance;
  RepresentationsOptions representations;
  ClassifyOptions classify;
  CertificateOptions certificate;

  /// Of the command that was given: its recipe, and the function that makes its report.
  Recipe recipe;
  std::function<Report(const EvaluationInput&)> make_report;
};

/// Declares the commands of mdbd-evaluate with their options and help. Parsing sets `recipe` and
/// `make_report`.
/// @param arguments outlives `app`, and stays where it is
void declare_commands(CLI::App& app, EvaluateArguments& arguments);

}  // namespace mdbd
