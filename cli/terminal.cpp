#include "cli/terminal.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/utf8.h"

namespace mdbd {
namespace {

unsigned char byte_at(std::string_view text, std::size_t position) {
  return position < text.size() ? static_cast<unsigned char>(text[position]) : 0;
}

/// Bytes that steer a terminal: C0, DEL and, in UTF-8, C1.
bool is_control(std::string_view text, std::size_t position) {
  const unsigned char byte = byte_at(text, position);
  return byte < 0x20 || byte == 0x7F || (byte == 0xC2 && byte_at(text, position + 1) < 0xA0);
}

std::string escape(std::string_view text, bool escapes_backslash) {
  std::string shown;
  for (std::size_t position = 0; position < text.size();) {
    const std::size_t length = utf8_length(text, position);
    if (text[position] == '\n') {
      shown += "\\n";
    } else if (text[position] == '\t') {
      shown += "\\t";
    } else if (text[position] == '\\' && escapes_backslash) {
      shown += "\\\\";
    } else if (length == 0 || is_control(text, position)) {
      for (std::size_t i = 0; i < std::max<std::size_t>(length, 1); ++i) {
        shown += fmt::format("\\x{:02x}", byte_at(text, position + i));
      }
    } else {
      shown += text.substr(position, length);
    }
    position += std::max<std::size_t>(length, 1);
  }
  return shown;
}

}  // namespace

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

bool colour_allowed(std::FILE* stream) {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool is_refused = no_colour != nullptr && *no_colour != '\0';
  const bool is_dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return is_terminal(stream) && !is_refused && !is_dumb;
}

int terminal_width(std::FILE* stream) {
  winsize size{};
  const bool is_known = ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : 80;
}

std::string printable(std::string_view text) { return escape(text, true); }

std::string printable_message(std::string_view text) { return escape(text, false); }

}  // namespace mdbd
