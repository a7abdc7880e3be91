#pragma once

#include <CLI/CLI.hpp>

namespace mdbd {

/// Adds an option for a number in a range.
template <typename Value, typename Bound>
CLI::Option* add_number(CLI::App& app, const char* name, Value& value, Bound lowest, Bound highest,
                        const char* description) {
  return app.add_option(name, value, description)
      ->check(CLI::Range(lowest, highest).description(""))
      ->type_name("N");
}

}  // namespace mdbd
