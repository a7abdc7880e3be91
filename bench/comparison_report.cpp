#include "bench/comparison_report.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "evaluation/measures/statistics.h"

namespace mdbd::bench {
namespace {

constexpr std::size_t slowest_shown = 8;
constexpr std::size_t first_rival = 1;

using Comparisons = std::span<const ModelComparison>;

template <typename Function>
std::vector<double> collect(Comparisons comparisons, const Function& function) {
  std::vector<double> values;
  for (const ModelComparison& comparison : comparisons) {
    values.push_back(static_cast<double>(function(comparison)));
  }
  return values;
}

// One number of a method on every model.
template <typename Function>
std::vector<double> collect(Comparisons comparisons, std::size_t method, const Function& function) {
  return collect(comparisons, [&](const ModelComparison& comparison) {
    return function(comparison.runs[method]);
  });
}

double median(const std::vector<double>& values) { return quantile(values, 0.5); }
double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::string milliseconds(double seconds) { return fmt::format("{:.1f}", 1e3 * seconds); }
std::string megabytes(double bytes) { return fmt::format("{:.1f}", 1e-6 * bytes); }
std::string percent(double share) { return fmt::format("{:.3g} %", 100.0 * share); }
std::string count(double number) { return fmt::format("{:.0f}", number); }

std::vector<double> times_of(Comparisons comparisons, std::size_t method) {
  return collect(comparisons, method, [](const MethodRun& run) { return run.seconds; });
}

std::vector<std::string> time_row(std::string_view name, const std::vector<double>& seconds,
                                  double reference_median) {
  return {std::string(name),
          milliseconds(median(seconds)),
          milliseconds(mean(seconds)),
          milliseconds(quantile(seconds, 0.9)),
          milliseconds(quantile(seconds, 0.99)),
          milliseconds(std::ranges::max(seconds)),
          fmt::format("{:.3f}", median(seconds) / reference_median)};
}

Table time_table(Comparisons comparisons) {
  Table table{.caption = "Processor time of one model, ms",
              .columns = {"", "median", "mean", "90 %", "99 %", "worst", "median / rival 128"},
              .rows = {},
              .is_summary = true};
  const double reference = median(times_of(comparisons, first_rival));
  for (std::size_t method = 0; method < method_count; ++method) {
    table.rows.push_back(time_row(method_names[method], times_of(comparisons, method), reference));
  }
  const auto fields =
      collect(comparisons, [](const ModelComparison& model) { return model.field_seconds; });
  table.rows.push_back(time_row("(building the field)", fields, reference));
  return table;
}

Table work_table(Comparisons comparisons) {
  Table table{.caption = "Work for one model, medians",
              .columns = {"", "distance queries", "ns per query, all included", "cells or voxels",
                          "memory, MB", "memory, worst, MB"},
              .rows = {},
              .is_summary = true};
  for (std::size_t method = 0; method < method_count; ++method) {
    const auto queries = collect(comparisons, method, [](const auto& run) { return run.queries; });
    const auto cells = collect(comparisons, method, [](const auto& run) { return run.cells; });
    const auto memory =
        collect(comparisons, method, [](const auto& run) { return run.peak_memory; });
    const auto nanoseconds = collect(comparisons, method, [](const MethodRun& run) {
      return 1e9 * run.seconds / static_cast<double>(std::max<std::uint64_t>(run.queries, 1));
    });
    table.rows.push_back({std::string(method_names[method]), count(median(queries)),
                          count(median(nanoseconds)), count(median(cells)),
                          megabytes(median(memory)), megabytes(std::ranges::max(memory))});
  }
  return table;
}

Table quality_table(Comparisons comparisons) {
  Table table{.caption = "Quality beside the certified decomposition",
              .columns = {"", "balls, mean", "radius error, mean", "radius error, worst",
                          "order violation, median", "order violation, worst", "contacts found",
                          "escape / R, worst", "overlap / R, worst"},
              .rows = {},
              .is_summary = true};
  const auto contacts_of = [&](std::size_t method) {
    return sum(collect(comparisons, method, [](const auto& run) { return run.quality.contacts; }));
  };
  for (std::size_t method = 0; method < method_count; ++method) {
    const auto of = [&](auto BallQuality::*member) {
      return collect(comparisons, method, [&](const auto& run) { return run.quality.*member; });
    };
    const std::vector<double> errors = of(&BallQuality::radius_error);
    const std::vector<double> violations = of(&BallQuality::order_violation);
    table.rows.push_back({std::string(method_names[method]),
                          fmt::format("{:.1f}", mean(of(&BallQuality::balls))),
                          percent(mean(errors)), percent(std::ranges::max(errors)),
                          percent(median(violations)), percent(std::ranges::max(violations)),
                          percent(contacts_of(method) / std::max(contacts_of(0), 1.0)),
                          fmt::format("{:.1e}", std::ranges::max(of(&BallQuality::escape))),
                          fmt::format("{:.1e}", std::ranges::max(of(&BallQuality::overlap)))});
  }
  return table;
}

Table slowest_table(Comparisons comparisons) {
  Table table{.caption = "The slowest models, ms",
              .columns = {"model", "triangles", "mdbd", "rival 128", "rival 256", "queries"},
              .rows = {},
              .is_summary = true};
  std::vector<ModelComparison> models(comparisons.begin(), comparisons.end());
  std::ranges::sort(models, std::ranges::greater(),
                    [](const ModelComparison& model) { return model.runs[0].seconds; });
  for (std::size_t i = 0; i < std::min(slowest_shown, models.size()); ++i) {
    std::vector<std::string> row = {models[i].name, std::to_string(models[i].triangles)};
    for (const MethodRun& run : models[i].runs) row.push_back(milliseconds(run.seconds));
    row.push_back(std::to_string(models[i].runs[0].queries));
    table.rows.push_back(row);
  }
  return table;
}

nlohmann::ordered_json to_json(const MethodRun& run) {
  return {{"cpu_seconds", run.seconds},
          {"distance_queries", run.queries},
          {"cells", run.cells},
          {"peak_memory_bytes", run.peak_memory},
          {"balls", run.quality.balls},
          {"contacts", run.quality.contacts},
          {"radius_error", run.quality.radius_error},
          {"order_violation", run.quality.order_violation},
          {"escape", run.quality.escape},
          {"overlap", run.quality.overlap}};
}

nlohmann::ordered_json to_json(const ModelComparison& model) {
  nlohmann::ordered_json object = {{"model", model.name},
                                   {"triangles", model.triangles},
                                   {"field_cpu_seconds", model.field_seconds}};
  for (std::size_t method = 0; method < method_count; ++method) {
    object["methods"][method_names[method]] = to_json(model.runs[method]);
  }
  return object;
}

std::string summarise(Comparisons comparisons) {
  const double ours = median(times_of(comparisons, 0));
  std::string text =
      fmt::format("{} models: {} ms a model", comparisons.size(), milliseconds(ours));
  for (std::size_t method = first_rival; method < method_count; ++method) {
    const double rival = median(times_of(comparisons, method));
    text += fmt::format(", {:.2f} of {}", ours / rival, method_names[method]);
  }
  return text + " (medians of processor time).";
}

}  // namespace

Report make_comparison_report(const std::string& title, Comparisons comparisons) {
  Report report;
  report.title = title;
  report.summary = summarise(comparisons);
  report.sections.push_back({"",
                             {time_table(comparisons), work_table(comparisons),
                              quality_table(comparisons), slowest_table(comparisons)}});
  for (const ModelComparison& model : comparisons) report.data["models"].push_back(to_json(model));
  return report;
}

}  // namespace mdbd::bench
