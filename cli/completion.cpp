#include <algorithm>
#include <iterator>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/documents.h"
#include "cli/option_list.h"

namespace mdbd {
namespace {

std::string join(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

std::vector<std::string> all_names(const std::vector<DocumentedOption>& options) {
  std::vector<std::string> names;
  for (const DocumentedOption& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::vector<std::string> command_names(const DocumentedCommand& program) {
  std::vector<std::string> names;
  for (const DocumentedCommand& command : program.commands) names.push_back(command.name);
  return names;
}

/// A text in single quotes of a shell of the Bourne family.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char character : text) {
    result += character == '\'' ? std::string("'\\''") : std::string(1, character);
  }
  return result + '\'';
}

// What follows an option with a value: one of the choices, or a file name ("complete -o default").
std::string bash_values(const DocumentedCommand& program) {
  std::vector<DocumentedOption> options = program.options;
  for (const DocumentedCommand& command : program.commands) {
    options.insert(options.end(), command.options.begin(), command.options.end());
  }
  std::string text;
  std::vector<std::string> seen;
  for (const DocumentedOption& option : options) {
    if (!option.has_value() || std::ranges::count(seen, option.names.back()) > 0) continue;
    seen.push_back(option.names.back());
    const std::string words = join(option.choices);
    fmt::format_to(std::back_inserter(text), "    {}) {}return ;;\n", fmt::join(option.names, "|"),
                   words.empty() ? ""
                                 : fmt::format("mapfile -t COMPREPLY < <(compgen -W \"{}\" -- "
                                               "\"$current\"); ",
                                               words));
  }
  return text;
}

std::string bash_completion(const DocumentedCommand& program) {
  std::string commands;
  for (const DocumentedCommand& command : program.commands) {
    fmt::format_to(std::back_inserter(commands),
                   "      {}) words+=\" {}\"; command=$word; break ;;\n", command.name,
                   join(all_names(command.options)));
  }
  std::string function = program.name;
  std::ranges::replace(function, '-', '_');
  return fmt::format(
      "# Completion of {0} for bash; written by {0} --completion bash.\n"
      "_{1}() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} command= word words=\"{2}\"\n"
      "  COMPREPLY=()\n"
      "  for word in \"${{COMP_WORDS[@]:1:COMP_CWORD-1}}\"; do\n"
      "    case $word in\n{3}      *) ;;\n    esac\n"
      "  done\n"
      "  case ${{COMP_WORDS[COMP_CWORD-1]}} in\n{4}    *) ;;\n  esac\n"
      "  if [[ $current != -* ]]; then\n"
      "    [[ -n $command ]] && return\n"
      "    words=\"{5}\"\n"
      "  fi\n"
      "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
      "}}\n"
      "complete -o default -F _{1} {0}\n",
      program.name, function, join(all_names(program.options)), commands, bash_values(program),
      join(command_names(program)));
}

/// A description inside the brackets of zsh's _arguments.
std::string zsh_description(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    if (character == '[' || character == ']' || character == ':' || character == '\\') {
      escaped += '\\';
    }
    escaped += character;
  }
  return escaped;
}

std::string zsh_options(const std::vector<DocumentedOption>& options, const std::string& indent) {
  std::string text;
  for (const DocumentedOption& option : options) {
    std::string value;
    if (option.has_value()) {
      value = option.choices.empty() ? ":value:_files"
                                     : fmt::format(":value:({})", join(option.choices));
    }
    for (const std::string& name : option.names) {
      text += indent +
              in_quotes(fmt::format("{}[{}]{}", name, zsh_description(option.description), value)) +
              " \\\n";
    }
  }
  return text;
}

std::string zsh_completion(const DocumentedCommand& program) {
  const std::string head =
      fmt::format("#compdef {0}\n# Completion of {0} for zsh; written by {0} --completion zsh.\n",
                  program.name);
  if (program.commands.empty()) {
    return head + "_arguments \\\n" + zsh_options(program.options, "  ") + "  '*:file:_files'\n";
  }
  std::string commands;
  for (const DocumentedCommand& command : program.commands) {
    commands +=
        fmt::format("  {}) _arguments \\\n{}{}    '*:file:_files' ;;\n", command.name,
                    zsh_options(command.options, "    "), zsh_options(program.options, "    "));
  }
  return head + "local context state state_descr line\ntypeset -A opt_args\n_arguments -C \\\n" +
         zsh_options(program.options, "  ") +
         fmt::format("  '1:command:({})' '*::argument:->arguments'\n",
                     join(command_names(program))) +
         "[[ $state == arguments ]] && case $words[1] in\n" + commands + "esac\n";
}

/// @param condition in front of the option, with a space after it
std::string fish_options(const std::string& program, const std::string& condition,
                         const std::vector<DocumentedOption>& options) {
  std::string text;
  for (const DocumentedOption& option : options) {
    fmt::format_to(std::back_inserter(text), "complete -c {} {}", program, condition);
    for (const std::string& name : option.names) {
      const bool is_long = name.starts_with("--");
      fmt::format_to(std::back_inserter(text), "{} {} ", is_long ? "-l" : "-s",
                     name.substr(is_long ? 2 : 1));
    }
    if (!option.choices.empty()) {
      fmt::format_to(std::back_inserter(text), "-x -a {} ", in_quotes(join(option.choices)));
    } else if (option.has_value()) {
      text += "-r ";
    }
    fmt::format_to(std::back_inserter(text), "-d {}\n", in_quotes(option.description));
  }
  return text;
}

std::string fish_completion(const DocumentedCommand& program) {
  std::string text =
      fmt::format("# Completion of {0} for fish; written by {0} --completion fish.\n",
                  program.name) +
      fish_options(program.name, "", program.options);
  for (const DocumentedCommand& command : program.commands) {
    fmt::format_to(std::back_inserter(text),
                   "complete -c {} -n __fish_use_subcommand -f -a {} -d {}\n", program.name,
                   command.name, in_quotes(command.description));
    text += fish_options(program.name,
                         fmt::format("-n '__fish_seen_subcommand_from {}' ", command.name),
                         command.options);
  }
  return text;
}

}  // namespace

std::string format_completion(const CLI::App& app, std::string_view shell) {
  const DocumentedCommand program = list_options(app);
  if (shell == "bash") return bash_completion(program);
  if (shell == "zsh") return zsh_completion(program);
  if (shell == "fish") return fish_completion(program);
  return {};
}

}  // namespace mdbd
