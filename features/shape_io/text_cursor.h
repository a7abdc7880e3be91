#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace mdbd {

/// Walks through the words of a text without copying it. Words are separated by blanks; a word that
/// begins with '#' begins a comment up to the end of the line; a backslash before a line end joins
/// two lines. Lines end with "\n", "\r\n" or "\r". The mark with which some editors begin a UTF-8
/// text is skipped.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text)
      : text_(text), position_(text.starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

  /// The next word on this line or a later one; empty at the end of the text.
  std::string_view next();

  /// The next word on this line; empty at its end, where the cursor stays.
  std::string_view next_in_line();

  /// Moves to the beginning of the next line.
  void skip_line();

  /// Moves backwards or forwards to a position, in bytes from the beginning.
  void move_to(std::size_t position) { position_ = position; }

  std::size_t position() const { return position_; }
  std::size_t remaining() const { return text_.size() - position_; }
  bool at_end() const { return position_ == text_.size(); }

  /// The line of the cursor, counted from 1. Takes time in proportion to the position.
  std::size_t line() const;

 private:
  bool at_line_end() const;
  std::size_t joined_line_length() const;
  void skip_blanks_in_line();

  std::string_view text_;
  std::size_t position_;
};

/// The whole word as a decimal number, whatever the locale. A number too large for a double is
/// infinite; "nan" and "inf" are read as such.
std::optional<double> parse_number(std::string_view word);

/// The whole word as a decimal integer, whatever the locale.
std::optional<std::int64_t> parse_integer(std::string_view word);

/// Whether two words are equal but for upper and lower case of ASCII letters.
bool equals_ignoring_case(std::string_view left, std::string_view right);

}  // namespace mdbd
