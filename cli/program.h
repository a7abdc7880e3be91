#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

/// What every program of the product does in the same way: version, exit codes, error messages.
namespace mdbd {

/// The exit codes of every program.
enum class ExitCode : int {
  done = 0,
  failed = 1,
  usage = 2,
  partial = 3  ///< done, but some models could not be read or decomposed
};

/// The version of the project: "0.1.0".
std::string_view version();

/// Parses the command line and calls `body`, the program's work, if there is work to do: the whole
/// of a main function after its options are declared. Adds --version.
///
/// `--man` alone prints the manual page, `--completion SHELL` alone a script (documents.h); both
/// are for packagers and no part of `--help`. `--help` and `--version` go to standard output. A
/// wrong command line ends with ExitCode::usage. An exception of `body`, or standard output that
/// cannot be written, is reported on standard error as "NAME: error: …", with the name of `app`,
/// and ends with ExitCode::failed.
/// @returns the exit code
int run_program(CLI::App& app, int argc, char** argv, const std::function<ExitCode()>& body);

/// Writes "NAME: error: MESSAGE" to standard error, on one line that is safe to show.
void print_error(std::string_view program, std::string_view message);

/// Writes "NAME: warning: MESSAGE" to standard error, on one line that is safe to show.
void print_warning(std::string_view program, std::string_view message);

}  // namespace mdbd
