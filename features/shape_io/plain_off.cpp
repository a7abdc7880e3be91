// OFF: comments, blank lines, colours, normals and texture coordinates go; counts that are glued to
// the header are set apart.
#include <algorithm>
#include <string>

#include "features/core/errors.h"
#include "features/shape_io/plain_file.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

// Reads "OFF", "COFF", "STOFF" … and leaves the cursor behind it, where counts may be glued.
void read_header(TextCursor& cursor) {
  const std::string_view word = cursor.next();
  const std::size_t name = word.find("OFF");
  const std::string_view prefix = word.substr(0, std::min(name, word.size()));
  if (name == word.npos || prefix.find_first_not_of("STCN4n") != prefix.npos) {
    throw InvalidInput("not an OFF file: it does not begin with OFF");
  }
  if (prefix.find_first_of("4n") != prefix.npos) {
    throw InvalidInput("an OFF file of points that are not three-dimensional is not supported");
  }
  cursor.move_to(cursor.position() - (word.size() - name - 3));
}

std::uint64_t read_count(TextCursor& cursor, std::string_view what) {
  const std::string_view word = cursor.next();
  if (word == "BINARY") {
    throw InvalidInput("binary OFF is not supported; save the model as text or as PLY");
  }
  const auto count = parse_integer(word);
  if (!count || *count < 0) {
    throw InvalidInput("the OFF header has no number of " + std::string(what));
  }
  return static_cast<std::uint64_t>(*count);
}

[[noreturn]] void fail_truncated(std::uint64_t found, std::uint64_t claimed, const char* what) {
  throw InvalidInput("truncated: the file ends after " + std::to_string(found) + " of " +
                     std::to_string(claimed) + " " + what);
}

[[noreturn]] void fail_malformed(const TextCursor& cursor, std::string_view word,
                                 const char* what) {
  throw InvalidInput("line " + std::to_string(cursor.line()) + ": '" +
                     std::string(word.substr(0, 40)) + "' is no " + what);
}

void read_vertices(TextCursor& cursor, std::uint64_t count, PlainOffWriter& writer) {
  while (writer.vertices() < count) {
    Eigen::Vector3d vertex;
    for (double& coordinate : vertex) {
      const std::string_view word = cursor.next();
      if (word.empty()) fail_truncated(writer.vertices(), count, "vertices");
      const auto number = parse_number(word);
      if (!number) fail_malformed(cursor, word, "coordinate");
      coordinate = *number;
    }
    writer.add_vertex(vertex);
    cursor.skip_line();
  }
}

void read_faces(TextCursor& cursor, std::uint64_t count, PlainOffWriter& writer) {
  std::vector<std::uint32_t> corners;
  const auto next_integer = [&](const char* what) {
    const std::string_view word = cursor.next();
    if (word.empty()) fail_truncated(writer.faces(), count, "faces");
    const auto integer = parse_integer(word);
    if (!integer) fail_malformed(cursor, word, what);
    return *integer;
  };
  while (writer.faces() < count) {
    const std::int64_t size = next_integer("number of corners");
    if (size < 0 || static_cast<std::uint64_t>(size) > cursor.remaining()) {
      throw InvalidInput("face " + std::to_string(writer.faces()) + " claims " +
                         std::to_string(size) + " corners, but the file has only " +
                         std::to_string(cursor.remaining()) + " bytes left");
    }
    corners.clear();
    for (std::int64_t i = 0; i < size; ++i) corners.push_back(to_index(next_integer("index")));
    writer.add_face(corners);
    cursor.skip_line();
  }
}

}  // namespace

PlainFile plain_off(std::string_view bytes) {
  TextCursor cursor(bytes);
  read_header(cursor);
  const std::uint64_t vertices = read_count(cursor, "vertices");
  const std::uint64_t faces = read_count(cursor, "faces");
  cursor.skip_line();  // with the number of edges, if it is there
  require_room(vertices, std::string_view("0 0 0\n").size(), "vertices", bytes.size());
  require_room(faces, std::string_view("0\n").size(), "faces", bytes.size());

  PlainOffWriter writer;
  read_vertices(cursor, vertices, writer);
  read_faces(cursor, faces, writer);
  return writer.finish();
}

}  // namespace mdbd
