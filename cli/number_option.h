#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace mdbd {

/// Checks that a text is a number in a range. CLI::Range lets "nan" pass.
template <typename Bound>
CLI::Validator is_within(Bound lowest, Bound highest) {
  const auto check = [lowest, highest](const std::string& text) -> std::string {
    Bound value{};
    const bool is_number = CLI::detail::lexical_cast(text, value);
    if (is_number && value >= lowest && value <= highest) return {};
    return fmt::format("Value {} not in range {} to {}", text, lowest, highest);
  };
  return CLI::Validator(check, "");
}

/// Adds an option for a number in a range.
template <typename Value, typename Bound>
CLI::Option* add_number(CLI::App& app, const char* name, Value& value, Bound lowest, Bound highest,
                        const char* description) {
  return app.add_option(name, value, description)
      ->check(is_within(lowest, highest))
      ->type_name("N");
}

}  // namespace mdbd
