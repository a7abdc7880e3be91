#include "evaluation/reports/certificate_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "evaluation/counted.h"
#include "evaluation/reports/certificate_checks.h"
#include "features/core/tolerances.h"

using nlohmann::ordered_json;

namespace mdbd {
namespace {

/// One of the guarantees, and how it is judged.
struct Check {
  const char* name;   ///< "contained"
  const char* key;    ///< in JSON
  const char* unit;   ///< what a violation is relative to
  const char* means;  ///< how a violation reads
  Violation RecheckedBalls::*violation;
  double allowed;
  bool judges_open;  ///< whether models with holes count, too
};

std::array<Check, 3> make_checks(const Recipe& recipe) {
  return {Check{"contained", "contained", "R", "a ball leaves the solid", &RecheckedBalls::escape,
                tolerances::containment, false},
          Check{"disjoint", "disjoint", "R", "two balls overlap", &RecheckedBalls::overlap,
                tolerances::containment, true},
          Check{"maximal", "maximal", "radius", "a larger ball fitted", &RecheckedBalls::excess,
                recipe.radius_tolerance, false}};
}

/// The judged models, the worst first.
std::vector<const CheckedModel*> rank(std::span<const CheckedModel> models, const Check& check,
                                      bool is_judged) {
  std::vector<const CheckedModel*> ranked;
  for (const CheckedModel& model : models) {
    if ((model.is_closed || check.judges_open) == is_judged) ranked.push_back(&model);
  }
  std::ranges::stable_sort(ranked, std::ranges::greater{}, [&](const CheckedModel* model) {
    return (model->result.*check.violation).size;
  });
  return ranked;
}

bool holds(const CheckedModel& model, const Check& check) {
  return (model.result.*check.violation).size <= check.allowed;
}

std::size_t count_broken(std::span<const CheckedModel* const> ranked, const Check& check) {
  return std::ranges::count_if(ranked, [&](const auto* model) { return !holds(*model, check); });
}

std::string show(double size) { return size > 0 ? fmt::format("{:.2g}", size) : "none"; }

/// Counted from 1, as in the radius list; one beyond the last ball is the one that is missing.
std::string show_ball(const CheckedModel& model, const Violation& violation) {
  if (!(violation.size > 0)) return "";
  return violation.ball < model.balls ? std::to_string(violation.ball + 1) : "a missing one";
}

// ---- Tables and charts ----

Section verdict_section(std::span<const CheckedModel> models, std::span<const Check> checks) {
  Table table{
      .caption = "Largest violations",
      .columns = {"guarantee", "models", "broken", "largest", "allowed", "of", "model", "ball"},
      .rows = {},
      .is_summary = true};
  for (const Check& check : checks) {
    const auto ranked = rank(models, check, true);
    std::vector<std::string> row{check.name, std::to_string(ranked.size()),
                                 std::to_string(count_broken(ranked, check))};
    if (ranked.empty()) {
      row.insert(row.end(), {"", fmt::format("{:.2g}", check.allowed), check.unit, "", ""});
    } else {
      const Violation& violation = ranked.front()->result.*check.violation;
      const bool is_any = violation.size > 0;
      row.insert(row.end(),
                 {show(violation.size), fmt::format("{:.2g}", check.allowed), check.unit,
                  is_any ? ranked.front()->model.name : "", show_ball(*ranked.front(), violation)});
    }
    table.rows.push_back(std::move(row));
  }
  return {
      "Verdict",
      {std::move(table),
       Paragraph{"R is the radius of the smallest ball that encloses a model. Distances are "
                 "measured to all triangles by another formula and another hierarchy than the "
                 "decomposition's, and the side of a point by adding up the solid angles of all "
                 "triangles. That balls are contained and disjoint is measured in full. That no "
                 "larger ball fitted is only tested, by climbing from random points for one: a "
                 "search that finds none proves nothing. The proof is the bound that the "
                 "decomposition keeps."}}};
}

Section search_section(std::span<const CheckedModel> models, double tolerance) {
  constexpr std::size_t steps = 5;  // up to the tolerance
  std::vector<double> counts(steps + 2, 0.0);
  double reach = 0.0;
  for (const CheckedModel& model : models) {
    const double share = model.result.excess.size / tolerance;
    const auto step = share > 1    ? static_cast<double>(steps + 1)
                      : share <= 0 ? 0.0
                                   : std::max(1.0, std::ceil(share * steps));
    ++counts[static_cast<std::size_t>(step)];
    reach += model.result.search_reach;
  }
  BarChart chart{.caption = "Models by the largest ball found that fitted in place of another",
                 .y_label = "models",
                 .categories = {"none larger"},
                 .bands = {},
                 .series = {{"models", std::move(counts)}}};
  for (std::size_t step = 1; step <= steps; ++step) {
    const double upper = 100 * tolerance * static_cast<double>(step) / steps;
    chart.categories.push_back(fmt::format("up to {:.3g} %", upper));
  }
  chart.categories.emplace_back("more");
  return {
      "The search for larger balls",
      {std::move(chart),
       Paragraph{fmt::format(
           "The search knows the earlier balls only. At {:.0f} % of the balls, mean over models, "
           "it met one of at least 99 % of the ball's radius by itself; that is how much it "
           "means where none larger was found. A ball may be larger than an earlier one by the "
           "radius tolerance of {:.3g} %.",
           100 * reach / static_cast<double>(models.size()), 100 * tolerance)}}};
}

Table worst_table(std::span<const CheckedModel* const> ranked, const Check& check,
                  std::string caption, std::size_t count) {
  Table table{.caption = std::move(caption),
              .columns = {"model", "triangles", "balls", "violation", "ball", "search reached, %"},
              .rows = {}};
  for (const CheckedModel* model : ranked.first(std::min(count, ranked.size()))) {
    const Violation& violation = model->result.*check.violation;
    table.rows.push_back({model->model.name, std::to_string(model->triangles),
                          std::to_string(model->balls), show(violation.size),
                          show_ball(*model, violation),
                          fmt::format("{:.0f}", 100 * model->result.search_reach)});
  }
  return table;
}

Section worst_section(std::span<const CheckedModel> models, std::span<const Check> checks,
                      std::size_t count) {
  Section section{"Worst models", {}};
  for (const bool is_judged : {true, false}) {
    for (const Check& check : checks) {
      std::vector<const CheckedModel*> ranked = rank(models, check, is_judged);
      std::erase_if(ranked, [&](const CheckedModel* model) {
        return !((model->result.*check.violation).size > 0);
      });
      if (ranked.empty()) continue;
      section.blocks.emplace_back(
          worst_table(ranked, check,
                      fmt::format("{}{}: {}, relative to {}", is_judged ? "" : "Not judged, ",
                                  check.name, check.means, check.unit),
                      count));
    }
  }
  return section;
}

// ---- Numbers ----

ordered_json violation_to_json(const Violation& violation) {
  return {{"size", violation.size}, {"ball", violation.ball + 1}};
}

ordered_json to_json(std::span<const CheckedModel> models, std::span<const Check> checks,
                     const RecheckOptions& search) {
  ordered_json verdicts;
  for (const Check& check : checks) {
    const auto ranked = rank(models, check, true);
    verdicts[check.key] = {{"allowed", check.allowed},
                           {"relative_to", check.unit},
                           {"models", ranked.size()},
                           {"broken", count_broken(ranked, check)}};
    if (ranked.empty()) continue;
    verdicts[check.key]["largest"] = (ranked.front()->result.*check.violation).size;
    verdicts[check.key]["model"] = ranked.front()->model.name;
  }
  ordered_json list = ordered_json::array();
  for (const CheckedModel& model : models) {
    ordered_json entry = {{"name", model.model.name},
                          {"triangles", model.triangles},
                          {"balls", model.balls},
                          {"is_closed", model.is_closed}};
    for (const Check& check : checks) {
      entry[check.key] = violation_to_json(model.result.*check.violation);
    }
    entry["search_reach"] = model.result.search_reach;
    list.push_back(std::move(entry));
  }
  return {{"verdicts", std::move(verdicts)},
          {"search",
           {{"samples", search.samples},
            {"samples_per_ball", search.samples_per_ball},
            {"climbs", search.climbs},
            {"climb_trials", search.climb_trials}}},
          {"models", std::move(list)}};
}

// ---- In words ----

std::string summarise(std::span<const CheckedModel> models, std::span<const Check> checks) {
  std::string broken;
  std::string found;
  for (const Check& check : checks) {
    const auto ranked = rank(models, check, true);
    if (ranked.empty()) continue;
    const double largest = (ranked.front()->result.*check.violation).size;
    found += fmt::format("{}{}: {} (allowed {:.2g} of {})", found.empty() ? "" : ", ", check.name,
                         show(largest), check.allowed, check.unit);
    if (const std::size_t count = count_broken(ranked, check); count > 0) {
      broken += fmt::format("{}{} by {}", broken.empty() ? "" : ", ", check.name,
                            counted(count, "model"));
    }
  }
  const std::string verdict =
      broken.empty() ? "No broken guarantee was found on " + counted(models.size(), "model")
                     : fmt::format("GUARANTEES ARE BROKEN: {}", broken);
  return fmt::format("{}. Largest violations found: {}.", verdict, found);
}

std::vector<std::string> make_notes(std::span<const CheckedModel> models) {
  const auto open = std::ranges::count(models, false, &CheckedModel::is_closed);
  if (open == 0) return {};
  return {
      counted(open, "model") + (open == 1 ? " has" : " have") +
      " an open surface, or triangles that disagree on what is outside. Where the inside ends is "
      "a matter of definition there: whether balls are contained and maximal is measured, but "
      "not judged."};
}

}  // namespace

Report make_certificate_report(const EvaluationInput& input, const CertificateOptions& options) {
  const std::vector<CheckedModel> models = check_models(input, options.search);
  const Recipe& recipe = input.cache.recipe();
  const std::array<Check, 3> checks = make_checks(recipe);
  Report report;
  report.title = "Certificate of " + input.collection.folder.filename().string();
  report.summary = summarise(models, checks);
  report.notes = make_notes(models);
  report.sections = {verdict_section(models, checks),
                     search_section(models, recipe.radius_tolerance),
                     worst_section(models, checks, options.worst)};
  report.data = to_json(models, checks, options.search);
  return report;
}

}  // namespace mdbd
