#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace mdbd {

bool is_terminal(std::FILE* stream);

/// Whether a stream is a terminal on which colour is welcome: NO_COLOR is unset or empty, and TERM
/// is neither unset nor "dumb".
bool colour_allowed(std::FILE* stream);

/// The number of columns of a terminal; 80 if it does not tell or is none.
int terminal_width(std::FILE* stream);

/// A text on one line, safe to show: control characters, which could steer a terminal, and bytes
/// that are no UTF-8 become "\n", "\t" or "\xNN", a backslash becomes "\\". File names may
/// hold any byte but zero.
std::string printable(std::string_view text);

/// As printable(), but a backslash stays: for messages, which may hold texts made printable before.
std::string printable_message(std::string_view text);

}  // namespace mdbd
