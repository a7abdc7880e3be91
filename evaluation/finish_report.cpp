#include "evaluation/finish_report.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "evaluation/counted.h"

namespace mdbd {
namespace {

using nlohmann::ordered_json;

constexpr std::string_view safe_characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
constexpr std::size_t failures_in_note = 3;

std::string quote(std::string_view word) {
  if (!word.empty() && word.find_first_not_of(safe_characters) == std::string_view::npos) {
    return std::string(word);
  }
  std::string quoted = "'";
  for (const char character : word) {
    quoted += character == '\'' ? std::string("'\\''") : std::string(1, character);
  }
  return quoted + "'";
}

std::size_t count_classes(const LabelledCollection& collection) {
  std::set<std::string_view> classes;
  for (const LabelledModel& model : collection.models) classes.insert(model.label);
  return classes.size();
}

std::string describe_recipe(const Recipe& recipe) {
  std::string text;
  for (const auto& [name, value] : to_entries(recipe)) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

/// "noise 0.5 %: chair/1.off", or the model alone where it failed as it is.
std::string place_of(const EvaluationFailure& failure) {
  return failure.stage.empty() ? failure.model : failure.stage + ": " + failure.model;
}

std::string failure_note(std::span<const EvaluationFailure> failures) {
  std::string text = counted(failures.size(), "failure") + ": ";
  const std::size_t listed = std::min(failures.size(), failures_in_note);
  for (std::size_t i = 0; i < listed; ++i) {
    text += fmt::format("{}{} ({})", i > 0 ? "; " : "", place_of(failures[i]), failures[i].reason);
  }
  if (listed < failures.size()) {
    text += fmt::format("; and {} more, listed at the end of the page", failures.size() - listed);
  }
  return text + ".";
}

Section failure_section(std::span<const EvaluationFailure> failures) {
  Table table{
      .caption = "Models that could not be used", .columns = {"model", "as", "reason"}, .rows = {}};
  for (const EvaluationFailure& failure : failures) {
    table.rows.push_back(
        {failure.model, failure.stage.empty() ? "it is" : failure.stage, failure.reason});
  }
  return {"Failures", {std::move(table)}};
}

ordered_json failures_to_json(std::span<const EvaluationFailure> failures) {
  ordered_json list = ordered_json::array();
  for (const EvaluationFailure& failure : failures) {
    list.push_back(
        {{"model", failure.model}, {"stage", failure.stage}, {"reason", failure.reason}});
  }
  return list;
}

}  // namespace

std::string join_command(std::span<const char* const> words) {
  std::string command;
  for (const char* word : words) command += (command.empty() ? "" : " ") + quote(word);
  return command;
}

void finish_report(Report& report, const EvaluationInput& input, const ReportOrigin& origin) {
  const LabelledCollection& collection = input.collection;
  const std::vector<EvaluationFailure>& failures = input.cache.failures();
  const std::size_t classes = count_classes(collection);
  report.provenance.insert(report.provenance.begin(),
                           {{"command", origin.command},
                            {"version", origin.version},
                            {"collection", fmt::format("{}: {} in {}", collection.folder.string(),
                                                       counted(collection.models.size(), "model"),
                                                       counted(classes, "class", "es"))},
                            {"recipe", describe_recipe(input.cache.recipe())},
                            {"seed", std::to_string(input.seed)}});
  std::vector<std::string> notes = collection.notes;
  if (!failures.empty()) {
    notes.push_back(failure_note(failures));
    report.sections.push_back(failure_section(failures));
  }
  report.notes.insert(report.notes.begin(), notes.begin(), notes.end());
  report.data["collection"] = {{"folder", collection.folder.string()},
                               {"models", collection.models.size()},
                               {"classes", classes}};
  report.data["failures"] = failures_to_json(failures);
}

bool has_failures(const EvaluationInput& input) {
  return !input.cache.failures().empty() || !input.collection.unusable.empty();
}

}  // namespace mdbd
