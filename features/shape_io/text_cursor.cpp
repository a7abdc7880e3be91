#include "features/shape_io/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace mdbd {
namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

char to_lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string_view without_plus(std::string_view word) {
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return has_plus ? word.substr(1) : word;
}

}  // namespace

bool TextCursor::at_line_end() const { return at_end() || is_line_end(text_[position_]); }

// How many bytes a backslash and the line end behind it take; 0 if there is none here.
std::size_t TextCursor::joined_line_length() const {
  const std::string_view rest = text_.substr(position_, 3);
  if (rest.starts_with("\\\r\n")) return 3;
  return rest.size() >= 2 && rest[0] == '\\' && is_line_end(rest[1]) ? 2 : 0;
}

void TextCursor::skip_blanks_in_line() {
  while (!at_line_end()) {
    if (is_blank(text_[position_])) {
      ++position_;
    } else if (const std::size_t length = joined_line_length(); length > 0) {
      position_ += length;
    } else {
      break;
    }
  }
  if (!at_end() && text_[position_] == '#') {
    while (!at_line_end()) ++position_;
  }
}

std::string_view TextCursor::next_in_line() {
  skip_blanks_in_line();
  const std::size_t begin = position_;
  while (!at_line_end() && !is_blank(text_[position_]) && joined_line_length() == 0) ++position_;
  return text_.substr(begin, position_ - begin);
}

std::string_view TextCursor::next() {
  std::string_view word = next_in_line();
  while (word.empty() && !at_end()) {
    ++position_;  // over the line end
    word = next_in_line();
  }
  return word;
}

void TextCursor::skip_line() {
  while (!at_line_end()) ++position_;
  if (at_end()) return;
  position_ += text_.substr(position_, 2) == "\r\n" ? 2 : 1;
}

std::size_t TextCursor::line() const {
  std::size_t line = 1;
  for (std::size_t i = 0; i < position_; ++i) {
    const bool ends_line = text_[i] == '\n' || (text_[i] == '\r' && text_.substr(i + 1, 1) != "\n");
    line += ends_line ? 1 : 0;
  }
  return line;
}

std::optional<double> parse_number(std::string_view word) {
  word = without_plus(word);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const bool is_tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
    return is_tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  word = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error != std::errc()) return std::nullopt;
  return value;
}

bool equals_ignoring_case(std::string_view left, std::string_view right) {
  return std::ranges::equal(left, right, {}, to_lower, to_lower);
}

}  // namespace mdbd
