#include "report/markup.h"

#include <algorithm>

#include "cli/utf8.h"

namespace mdbd {
namespace {

/// Whether XML 1.0 allows a well-formed character (its section 2.2).
bool is_allowed(std::string_view character) {
  if (character.size() == 1) {
    const auto byte = static_cast<unsigned char>(character[0]);
    return byte >= 0x20 || byte == '\t' || byte == '\n';
  }
  return character != "\xEF\xBF\xBE" && character != "\xEF\xBF\xBF";
}

std::string_view escape_character(std::string_view character) {
  if (character == "&") return "&amp;";
  if (character == "<") return "&lt;";
  if (character == ">") return "&gt;";
  if (character == "\"") return "&quot;";
  if (character == "'") return "&#39;";
  return character;
}

}  // namespace

std::string escape_markup(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (std::size_t position = 0; position < text.size();) {
    const std::size_t length = utf8_length(text, position);
    const std::string_view character = text.substr(position, length);
    escaped += length > 0 && is_allowed(character) ? escape_character(character) : "\xEF\xBF\xBD";
    position += std::max<std::size_t>(length, 1);
  }
  return escaped;
}

}  // namespace mdbd
