#include "cli/program.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/documents.h"
#include "cli/terminal.h"

namespace mdbd {
namespace {

void print_labelled(std::string_view program, std::string_view label, const char* colour,
                    std::string_view message) {
  const bool is_coloured = colour_allowed(stderr);
  const std::string text =
      fmt::format("{}: {}{}:{} {}\n", program, is_coloured ? colour : "", label,
                  is_coloured ? "\x1b[0m" : "", printable_message(message));
  std::fwrite(text.data(), 1, text.size(), stderr);
}

int to_int(ExitCode code) { return static_cast<int>(code); }

/// Results that did not reach their reader are a failure: a full disk behind "> matches.csv".
ExitCode flush_results(std::string_view program, ExitCode code) {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  const std::string cause = errno != 0 ? fmt::format(": {}", std::strerror(errno)) : "";
  print_error(program, "cannot write to standard output" + cause);
  return ExitCode::failed;
}

/// A document of the program, if the command line asks for one and nothing else.
std::string asked_document(const CLI::App& app, int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "--man") return format_man_page(app, version());
  if (argc == 3 && std::string_view(argv[1]) == "--completion") {
    return format_completion(app, argv[2]);
  }
  return {};
}

}  // namespace

std::string_view version() { return MDBD_VERSION; }

void print_error(std::string_view program, std::string_view message) {
  print_labelled(program, "error", "\x1b[1;31m", message);
}

void print_warning(std::string_view program, std::string_view message) {
  print_labelled(program, "warning", "\x1b[1;33m", message);
}

int run_program(CLI::App& app, int argc, char** argv, const std::function<ExitCode()>& body) {
  const std::string program = app.get_name();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of writing it
  try {
    app.set_version_flag("--version", fmt::format("{} {}", program, version()),
                         "Print the version and exit");
    if (const std::string text = asked_document(app, argc, argv); !text.empty()) {
      fmt::print("{}", text);
      return to_int(flush_results(program, ExitCode::done));
    }
    app.parse(argc, argv);
    return to_int(flush_results(program, body()));
  } catch (const CLI::Success& request) {  // --help, --version
    app.exit(request);
    return to_int(flush_results(program, ExitCode::done));
  } catch (const CLI::Error& error) {
    print_error(program, error.what());
    fmt::print(stderr, "Run \"{} --help\" for the options.\n", program);
    return to_int(ExitCode::usage);
  } catch (const std::bad_alloc&) {
    print_error(program, "out of memory");
  } catch (const std::exception& error) {
    print_error(program, error.what());
  } catch (...) {
    print_error(program, "unknown failure");
  }
  return to_int(ExitCode::failed);
}

}  // namespace mdbd
