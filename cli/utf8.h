#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Texts that may come from anywhere, such as file names: mostly UTF-8, never certainly.
namespace mdbd {

/// The number of bytes of the well-formed UTF-8 character at a position (Unicode, table 3-7), or 0
/// if there is none.
std::size_t utf8_length(std::string_view text, std::size_t position);

/// How many columns a text takes on a terminal: most characters one, those of East Asia two.
std::size_t display_width(std::string_view text);

/// A text of at most so many columns; what is cut off at its end is shown as "…".
/// @pre columns > 0
std::string shorten(std::string_view text, std::size_t columns);

}  // namespace mdbd
