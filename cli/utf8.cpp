#include "cli/utf8.h"

#include <algorithm>

#include <fmt/format.h>

namespace mdbd {
namespace {

unsigned char byte_at(std::string_view text, std::size_t position) {
  return position < text.size() ? static_cast<unsigned char>(text[position]) : 0;
}

}  // namespace

std::size_t utf8_length(std::string_view text, std::size_t position) {
  const unsigned char lead = byte_at(text, position);
  if (lead < 0x80) return position < text.size() ? 1 : 0;
  const std::size_t length = lead < 0xC2   ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  const unsigned char lowest = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const unsigned char highest = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned char next = byte_at(text, position + i);
    if (next < (i == 1 ? lowest : 0x80) || next > (i == 1 ? highest : 0xBF)) return 0;
  }
  return length;
}

std::size_t display_width(std::string_view text) {
  // fmt knows the widths and tells them by the blanks that it adds.
  const std::size_t padded = fmt::formatted_size("{:<{}}", text, text.size());
  return text.size() - (padded - text.size());
}

std::string shorten(std::string_view text, std::size_t columns) {
  if (display_width(text) <= columns) return std::string(text);
  std::size_t end = 0;
  while (true) {
    const std::size_t next = end + std::max<std::size_t>(utf8_length(text, end), 1);
    if (display_width(text.substr(0, next)) + 1 > columns) break;
    end = next;
  }
  return std::string(text.substr(0, end)) + "…";
}

}  // namespace mdbd
