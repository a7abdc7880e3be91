#include "cli/text_output.h"

#include "cli/terminal.h"

namespace mdbd {

std::string csv_field(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char character : field) {
    if (character == '"') quoted += '"';
    quoted += character;
  }
  return quoted + '"';
}

std::string shown_path(const std::string& path, const std::filesystem::path& directory) {
  const std::filesystem::path relative = std::filesystem::path(path).lexically_relative(directory);
  const bool is_below = !relative.empty() && *relative.begin() != "..";
  return printable(is_below ? relative.string() : path);
}

}  // namespace mdbd
