#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

/// What is installed beside a program, written from the declarations of its options, so that it
/// cannot say anything else than they do.
namespace mdbd {

/// A manual page (section 1, man macros). Of the footer, the lines after "Examples:" become the
/// examples, the paragraph "Exit codes: …" the exit status, and everything else notes.
std::string format_man_page(const CLI::App& app, std::string_view version);

/// A script that completes options, their values where there is a choice of them, and subcommands;
/// everything else is completed as file names.
/// @param shell "bash", "zsh" or "fish"
/// @returns an empty string for another shell
std::string format_completion(const CLI::App& app, std::string_view shell);

}  // namespace mdbd
