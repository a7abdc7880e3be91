#include "cli/option_list.h"

#include <CLI/CLI.hpp>

namespace mdbd {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts = CLI::detail::split(text, separator);
  return parts.size() > 1 ? parts : std::vector<std::string>{};
}

/// The values of a type name such as "MODE:{auto,off}" or "off|obj".
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return split(type, '|');
  return split(type.substr(open + 1, close - open - 1), ',');
}

DocumentedOption document(const CLI::Option& option) {
  DocumentedOption result;
  for (const std::string& name : option.get_snames()) result.names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  const std::string type = option.get_type_name();
  result.choices = choices_of(type);
  if (option.get_items_expected_max() > 0) result.value = type.substr(0, type.find(':'));
  result.description = option.get_description();
  result.default_value = option.get_default_str();
  result.environment = option.get_envname();
  return result;
}

DocumentedOption document_positional(const CLI::Option& option) {
  DocumentedOption result = document(option);
  result.value = option.get_name(true);
  if (option.get_expected_max() > 1) result.value += "...";
  if (!option.get_required()) result.value = '[' + result.value + ']';
  return result;
}

}  // namespace

DocumentedCommand list_options(const CLI::App& app) {
  DocumentedCommand result{.name = app.get_name(),
                           .description = app.get_description(),
                           .options = {},
                           .positionals = {},
                           .commands = {}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    if (option->get_positional()) {
      result.positionals.push_back(document_positional(*option));
    } else {
      result.options.push_back(document(*option));
    }
  }
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    result.commands.push_back(list_options(*command));
  }
  return result;
}

}  // namespace mdbd
