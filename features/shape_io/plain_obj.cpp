// OBJ: only vertices and faces are kept. It becomes an OFF file, because OpenMesh's OBJ reader
// opens the material files that are named, skips vertices that it cannot parse, which shifts all
// indices behind them, and parses numbers by the locale of the process.
#include <string>

#include "features/core/errors.h"
#include "features/shape_io/plain_file.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

[[noreturn]] void fail(const TextCursor& cursor, const std::string& reason) {
  throw InvalidInput("line " + std::to_string(cursor.line()) + ": " + reason);
}

// "x y z", perhaps followed by a weight or a colour.
Eigen::Vector3d read_vertex(TextCursor& cursor) {
  Eigen::Vector3d vertex;
  for (double& coordinate : vertex) {
    const std::string_view word = cursor.next_in_line();
    if (word.empty()) fail(cursor, "the vertex has fewer than three coordinates");
    const auto number = parse_number(word);
    if (!number) fail(cursor, "'" + std::string(word.substr(0, 40)) + "' is no coordinate");
    coordinate = *number;
  }
  return vertex;
}

// "7", "7/1", "7//3" or "7/1/3"; counted from 1, negative ones backwards from the latest vertex.
std::uint32_t read_corner(const TextCursor& cursor, std::string_view word, std::uint64_t vertices) {
  const auto index = parse_integer(word.substr(0, word.find('/')));
  if (!index) fail(cursor, "'" + std::string(word.substr(0, 40)) + "' is no index");
  return to_index(*index < 0 ? static_cast<std::int64_t>(vertices) + *index : *index - 1);
}

}  // namespace

PlainFile plain_obj(std::string_view bytes) {
  PlainOffWriter writer;
  std::vector<std::uint32_t> corners;
  for (TextCursor cursor(bytes); !cursor.at_end(); cursor.skip_line()) {
    const std::string_view keyword = cursor.next_in_line();
    if (keyword == "v") {
      writer.add_vertex(read_vertex(cursor));
    } else if (keyword == "f") {
      corners.clear();
      for (std::string_view word = cursor.next_in_line(); !word.empty();
           word = cursor.next_in_line()) {
        corners.push_back(read_corner(cursor, word, writer.vertices()));
      }
      writer.add_face(corners);
    }
  }
  return writer.finish();
}

}  // namespace mdbd
