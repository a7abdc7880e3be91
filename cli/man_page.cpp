#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/documents.h"
#include "cli/option_list.h"

namespace mdbd {
namespace {

/// A text for troff: its control characters mean themselves, a hyphen is the one that is typed.
std::string roff(std::string_view text) {
  std::string escaped;
  bool is_line_start = true;
  for (const char character : text) {
    if (is_line_start && (character == '.' || character == '\'')) escaped += "\\&";
    if (character == '\\') {
      escaped += "\\e";
    } else if (character == '-') {
      escaped += "\\-";
    } else {
      escaped += character;
    }
    is_line_start = character == '\n';
  }
  return escaped;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string upper_case(std::string text) {
  for (char& character : text) character = static_cast<char>(std::toupper(character));
  return text;
}

/// "Finds the models." as the part of a NAME section: "finds the models".
std::string as_phrase(std::string description) {
  if (description.ends_with('.')) description.pop_back();
  if (!description.empty()) {
    description[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(description[0])));
  }
  return description;
}

std::string describe(const DocumentedOption& option) {
  std::string text = roff(option.description);
  if (!text.ends_with('.')) text += '.';
  if (!option.choices.empty())
    text += " One of " + roff(fmt::format("{}", fmt::join(option.choices, ", "))) + '.';
  if (!option.environment.empty()) {
    text += fmt::format(" If it is not given, the environment variable {} has it.",
                        bold(option.environment));
  }
  if (!option.default_value.empty()) text += " Default: " + roff(option.default_value) + '.';
  return text;
}

std::string option_items(const std::vector<DocumentedOption>& options) {
  std::string text;
  for (const DocumentedOption& option : options) {
    std::string head;
    for (const std::string& name : option.names) head += (head.empty() ? "" : ", ") + bold(name);
    if (option.has_value()) head += (head.empty() ? "" : " ") + italic(option.value);
    text += fmt::format(".TP\n{}\n{}\n", head, describe(option));
  }
  return text;
}

std::string synopsis(const std::string& name, const DocumentedCommand& command) {
  std::string text = bold(name) + " [" + italic("OPTIONS") + ']';
  if (!command.commands.empty()) text += ' ' + italic("COMMAND");
  for (const DocumentedOption& positional : command.positionals)
    text += ' ' + italic(positional.value);
  return text;
}

std::string command_sections(const DocumentedCommand& program) {
  if (program.commands.empty()) return "";
  std::string text = ".SH COMMANDS\n";
  for (const DocumentedCommand& command : program.commands) {
    text += fmt::format(".SS {}\n{}.\n{}{}", synopsis(program.name + ' ' + command.name, command),
                        roff(command.description), option_items(command.positionals),
                        option_items(command.options));
  }
  return text;
}

/// A paragraph of a footer.
std::string footer_section(std::string_view paragraph) {
  constexpr std::string_view examples = "Examples:\n";
  constexpr std::string_view codes = "Exit codes: ";
  if (paragraph.starts_with(examples)) {
    return fmt::format(".SH EXAMPLES\n.nf\n{}\n.fi\n", roff(paragraph.substr(examples.size())));
  }
  const std::size_t at = paragraph.find(codes);
  std::string text;
  if (at != 0) text = fmt::format(".SH NOTES\n{}\n", roff(paragraph.substr(0, at)));
  if (at != std::string_view::npos) {
    text += fmt::format(".SH EXIT STATUS\n{}\n", roff(paragraph.substr(at + codes.size())));
  }
  return text;
}

std::string footer_sections(std::string_view footer) {
  std::string text;
  while (!footer.empty()) {
    const std::size_t end = std::min(footer.find("\n\n"), footer.size());
    text += footer_section(footer.substr(0, end));
    footer.remove_prefix(std::min(end + 2, footer.size()));
  }
  return text;
}

std::string see_also(const std::string& name) {
  constexpr std::array programs = {"mdbd-db",    "mdbd-decompose", "mdbd-evaluate",
                                   "mdbd-index", "mdbd-perturb",   "mdbd-query"};
  std::vector<std::string> others;
  for (const std::string_view program : programs) {
    if (program != name) others.push_back(bold(program) + "(1)");
  }
  return fmt::format(".SH SEE ALSO\n{}\n", fmt::join(others, ",\n"));
}

}  // namespace

std::string format_man_page(const CLI::App& app, std::string_view version) {
  const DocumentedCommand program = list_options(app);
  return fmt::format(
      ".TH {} 1 \"\" \"mdbd {}\" \"User Commands\"\n"
      ".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}\n.SH DESCRIPTION\n{}\n{}.SH OPTIONS\n{}{}{}{}",
      roff(upper_case(program.name)), version, roff(program.name),
      roff(as_phrase(program.description)), synopsis(program.name, program),
      roff(program.description), option_items(program.positionals), option_items(program.options),
      command_sections(program), footer_sections(app.get_footer()), see_also(program.name));
}

}  // namespace mdbd
