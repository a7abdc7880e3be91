// STL: text becomes binary, binary is cut to the triangles that its header counts. Which of the two
// a file is, its size and its bytes tell; the word "solid" at its beginning proves nothing.
#include <bit>
#include <cstring>
#include <string>
#include <utility>

#include "features/core/errors.h"
#include "features/shape_io/plain_file.h"
#include "features/shape_io/text_cursor.h"

namespace mdbd {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

constexpr std::size_t title_size = 80;   // bytes
constexpr std::size_t header_size = 84;  // the title and the number of triangles
constexpr std::size_t record_size = 50;  // a normal, three corners, two spare bytes
constexpr std::size_t normal_size = 12;

std::uint32_t claimed_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + title_size, sizeof count);
  return count;
}

std::uint64_t binary_size(std::uint64_t triangles) { return header_size + record_size * triangles; }

bool has_binary_size(std::string_view bytes) {
  return bytes.size() >= header_size && bytes.size() == binary_size(claimed_triangles(bytes));
}

bool contains_null(std::string_view bytes) {
  return bytes.substr(0, 1024).find('\0') != bytes.npos;
}

bool looks_like_text(std::string_view bytes) {
  if (contains_null(bytes)) return false;
  const std::string_view first = TextCursor(bytes).next();
  return equals_ignoring_case(first, "solid") || equals_ignoring_case(first, "facet");
}

void require_usable_records(std::string_view records) {
  for (std::uint64_t i = 0; i * record_size < records.size(); ++i) {
    Eigen::Matrix3f corners;  // one a column
    std::memcpy(corners.data(), records.data() + i * record_size + normal_size, sizeof(float) * 9);
    for (int k = 0; k < 3; ++k) require_usable(corners.col(k).cast<double>(), 3 * i + k);
  }
}

PlainFile make_plain(std::string bytes) {
  const std::uint64_t triangles = claimed_triangles(bytes);
  require_faces(0, triangles);
  require_usable_records(std::string_view(bytes).substr(header_size));
  PlainFile file;
  file.extension = "stl";
  file.is_binary = true;
  file.vertices = 3 * triangles;
  file.faces = triangles;
  file.bytes = std::move(bytes);
  return file;
}

PlainFile plain_binary(std::string_view bytes) {
  if (bytes.size() < header_size) {
    throw InvalidInput("truncated: the file has " + std::to_string(bytes.size()) +
                       " bytes, the header alone takes " + std::to_string(header_size));
  }
  const std::uint32_t triangles = claimed_triangles(bytes);
  if (bytes.size() < binary_size(triangles)) {
    throw InvalidInput("truncated: header claims " + std::to_string(triangles) + " triangles (" +
                       std::to_string(binary_size(triangles)) + " bytes), file has " +
                       std::to_string(bytes.size()) + " bytes");
  }
  return make_plain(std::string(bytes.substr(0, binary_size(triangles))));
}

/// Collects the records of a binary STL from the words of a text one.
class TextReader {
 public:
  explicit TextReader(std::string_view text) : cursor_(text), bytes_(header_size, '\0') {}

  std::string read() {
    for (std::string_view word = cursor_.next(); !word.empty(); word = cursor_.next()) {
      take(word);
    }
    if (in_solid_ || in_facet_) fail_truncated();
    std::memcpy(bytes_.data() + title_size, &triangles_, sizeof triangles_);
    return std::move(bytes_);
  }

 private:
  void take(std::string_view word) {
    if (equals_ignoring_case(word, "solid") || equals_ignoring_case(word, "endsolid")) {
      in_solid_ = word.size() == std::string_view("solid").size();
      cursor_.skip_line();  // a name, of any words
    } else if (equals_ignoring_case(word, "facet")) {
      begin_facet();
    } else if (equals_ignoring_case(word, "vertex")) {
      take_vertex();
    } else if (equals_ignoring_case(word, "endfacet")) {
      end_facet();
    }
  }

  void begin_facet() {
    if (in_facet_) fail("a facet begins within a facet");
    in_facet_ = true;
    corners_ = 0;
    bytes_.append(normal_size, '\0');
  }

  void take_vertex() {
    if (!in_facet_) fail("a vertex outside of a facet");
    if (corners_ == 3) fail("a facet has more than three corners");
    Eigen::Vector3d vertex;
    for (double& coordinate : vertex) {
      const std::string_view word = cursor_.next();
      if (word.empty()) fail_truncated();
      const auto number = parse_number(word);
      if (!number) fail("'" + std::string(word.substr(0, 40)) + "' is no coordinate");
      coordinate = *number;
    }
    require_usable(vertex, 3 * std::uint64_t{triangles_} + corners_++);
    const Eigen::Vector3f corner = vertex.cast<float>();
    append_bytes(corner.data(), sizeof(float) * 3);
  }

  void end_facet() {
    if (!in_facet_ || corners_ != 3) fail("a facet has fewer than three corners");
    in_facet_ = false;
    bytes_.append(2, '\0');
    ++triangles_;
  }

  void append_bytes(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }

  [[noreturn]] void fail_truncated() const {
    throw InvalidInput("truncated: the text ends after " + std::to_string(triangles_) +
                       " triangles without endsolid");
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw InvalidInput("line " + std::to_string(cursor_.line()) + ": " + reason);
  }

  TextCursor cursor_;
  std::string bytes_;
  std::uint32_t triangles_ = 0;
  int corners_ = 0;
  bool in_solid_ = false;
  bool in_facet_ = false;
};

}  // namespace

PlainFile plain_stl(std::string_view bytes) {
  if (has_binary_size(bytes)) return plain_binary(bytes);
  if (looks_like_text(bytes)) return make_plain(TextReader(bytes).read());
  if (!contains_null(bytes)) {
    throw InvalidInput("not an STL file: neither the text form nor the size of the binary one");
  }
  return plain_binary(bytes);
}

}  // namespace mdbd
