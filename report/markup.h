#pragma once

#include <string>
#include <string_view>

namespace mdbd {

/// A text as the content or the quoted attribute of an HTML, SVG or XML element. Bytes that are no
/// UTF-8 and characters that XML forbids become U+FFFD.
std::string escape_markup(std::string_view text);

}  // namespace mdbd
